#include "passive_surface.h"

namespace facenav::tracking {
FaceSurface passiveSurface(const stereo::StereoRig& rig, const stereo::StereoFrame&, const FaceRegion&,
                           double) {
  return FaceSurface({}, {}, {rig.width_px, rig.height_px});
}
}  // namespace facenav::tracking
