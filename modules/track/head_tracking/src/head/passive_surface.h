#pragma once
// The face's depth without projected dots: plane-sweep NCC of the plain reference pair, completed over smooth
// skin by semi-global smoothing (Hirschmueller 2008), sub-pixel. Error about a millimetre; dense dots give
// 0.2 mm.

#include "facenav/cameras/stereo_frame.h"
#include "head/face_surface.h"

namespace facenav::head_tracking {

/// Searches depths within 15 % of `start_depth_mm`.
FaceSurface passiveSurface(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                           const FaceRegion& region, double start_depth_mm);

}  // namespace facenav::head_tracking
