#pragma once
// One pose from the paper's features (section 4, equation 2), and its acceptance test.
//
// NCC alone is no protection: two exchanged eye corners still score 0.95-0.98. So the features must keep
// their
// mutual distances: every triple proposes a motion, and the one with the most inliers is kept. The pose of
// equation 2 must also reproject onto both images. It is then refined in the images, a deviation from the
// paper: triangulation turns a quarter of a pixel into a millimetre of depth; the joint fit has a third of
// that error.

#include <vector>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/core/tracked.h"
#include "facenav/geometry/rotation.h"

namespace facenav::peers {

/// One feature found in both images.
struct FeatureMatch {
  int feature = 0;  // index into the reference points
  Eigen::Vector2d left_px, right_px;
  double weight = 0.0;  // NCC, the w_i of equation 2
};

struct FeatureFit {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();  // camera_T_head
  Matrix6d covariance = Matrix6d::Zero();                    // about `centre_mm`, see HeadPose
  Eigen::Vector3d centre_mm = Eigen::Vector3d::Zero();
  double rms_px = 0.0;
  std::vector<FeatureMatch> inliers;
};

/// Returns the motion of `reference_mm` (Camera at the reference) that explains the matches, or
/// Lost{few_features} or Lost{high_residual}.
Tracked<FeatureFit> fitFeatures(const cameras::StereoRig& rig,
                                const std::vector<Eigen::Vector3d>& reference_mm,
                                const std::vector<FeatureMatch>& matches);

}  // namespace facenav::peers
