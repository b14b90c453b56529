#pragma once
// Bundle adjustment of a rig: both cameras' parameters, their relative pose and all board poses together, by
// Levenberg-Marquardt on the reprojection error in both images (Zhang 2000; Triggs et al. 2000). A prior
// covers what views often do not determine (rig_prior.h); errors come from rig_covariance.h. Own code,
// because cv::stereoCalibrate takes a second where 10 ms suffice and gives no parameter covariance, and
// cross-validation solves dozens of times.

#include "facenav/cameras/calibrate.h"

namespace facenav::cameras {

/// Terms of the lens distortion.
struct LensTerms {
  int coefficients = 4;       // 4: k1 k2 p1 p2; 5: and k3; 8: rational
  bool is_tangential = true;  // false: p1 = p2 = 0
};

struct RigFit {
  StereoRig rig;
  double focal_sigma_px =
      0;  // standard errors by rig_covariance.h; focal: the largest of fx and fy of both cameras
  double baseline_sigma_mm = 0;
};

/// Fits the rig. Throws Error if the views do not determine the cameras.
RigFit adjustRig(const std::vector<const BoardView*>& views, const cv::Size& image_size, const Board& board,
                 const LensTerms& lens);

}  // namespace facenav::cameras
