#pragma once
// Bundle adjustment of a rig: both cameras' parameters, their relative pose and all board poses together, by
// Levenberg-Marquardt on the reprojection error in both images (Zhang 2000; Triggs et al. 2000) and a prior
// on what views often leave open (rig_prior.h); errors by rig_covariance.h. Written out because
// cv::stereoCalibrate takes a second for what 10 ms suffice, gives no parameter covariance, and
// cross-validation solves dozens of times.

#include "facenav/cameras/calibrate.h"

namespace facenav::cameras {

/// Which terms the lens distortion has.
struct LensTerms {
  int coefficients = 4;       // 4: k1 k2 p1 p2; 5: and k3; 8: rational
  bool is_tangential = true;  // false: p1 = p2 = 0
};

struct RigFit {
  StereoRig rig;
  double focal_sigma_px = 0;  // standard deviations by rig_covariance.h: the larger of fx, fy, both cameras
  double baseline_sigma_mm = 0;
};

/// Throws Error when the views do not determine the cameras.
RigFit adjustRig(const std::vector<const BoardView*>& views, const cv::Size& image_size, const Board& board,
                 const LensTerms& lens);

}  // namespace facenav::cameras
