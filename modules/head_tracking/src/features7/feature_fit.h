#pragma once
// One pose from the paper's features (section 4, equation 2), and whether it can be believed.
//
// NCC is no guard: two swapped eye corners still score 0.95-0.98. So the features must keep their mutual
// distances (every triple proposes a motion, the one most features agree with is kept), and the pose of
// equation 2 must reproject onto both images. That pose is then refined in the images: triangulation turns a
// quarter of a pixel into a millimetre of depth, the joint fit does not (a third of the error; a deviation
// from the paper).

#include <vector>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/core/tracked.h"
#include "facenav/geometry/rotation.h"

namespace facenav::head_tracking {

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

/// The motion of `reference_mm` (Camera at the reference) that explains the matches; Lost{few_features} or
/// Lost{high_residual} where none does.
Tracked<FeatureFit> fitFeatures(const cameras::StereoRig& rig,
                                const std::vector<Eigen::Vector3d>& reference_mm,
                                const std::vector<FeatureMatch>& matches);

}  // namespace facenav::head_tracking
