#pragma once
// FaceOffset: how far a face lies off its epipolar lines, and the error of depth that this means. A camera
// that turned, or a head that moved between the two exposures, shifts the face across its lines. It shifts
// the face along the lines as far, and only depth shows that.

#include <vector>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/health/observation.h"

namespace facenav::health {

struct FaceOffset {
  double median_px = 0;  // signed, right camera
  double sigma_px = 0;   // standard error: of the median, the calibration and the lens model at that place
  double depth_mm = 0;   // Camera; 0 without matches

  bool isSignificant() const;
};

/// Offset of the face's matches. Matches behind the cameras do not count; without any, all values are 0.
FaceOffset faceOffset(const cameras::StereoRig& rig, const std::vector<Correspondence>& matches);

/// Offset across the lines (px, right camera) of a motion that changes the depth by `error_mm` if it goes as
/// far along the lines: depth / baseline times as much.
double offsetOfDepthError_px(const cameras::StereoRig& rig, double error_mm, double depth_mm);

}  // namespace facenav::health
