#pragma once
// RecoveryPose: the head's pose from skin matches (skin_points.h). Robust least squares over both cameras,
// coarse to fine. A match's weight decreases with the usual motion of its skin over the bone
// (skin_mobility.h); outliers are handled by Student's t (Lange, Little, Taylor 1989). At the finest level
// the skin's motion is estimated together with the pose (skin_field.h), and the covariance includes it.

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "facenav/geometry/rotation.h"
#include "skin_points.h"

namespace facenav::head_tracking {

struct RecoveryPose {
  Eigen::Isometry3d camera_T_head = Eigen::Isometry3d::Identity();
  /// Covariance of xi = (w rad, v mm) as in HeadPose, about the points' centre, in Camera's axes.
  Matrix6d covariance = Matrix6d::Identity() * 1e6;
  /// Covariance, in the same form, of errors that no image shows: rig, shape, and changes between two
  /// sessions. Not part of `covariance`.
  Matrix6d unseen_covariance = Matrix6d::Zero();
  std::vector<SkinMatch> matches;   // of the last search; offsets refer to the pose before the last step
  std::vector<double> residual_px;  // per match, with the motion of head and skin
  /// Squared Mahalanobis distance between the poses from each camera alone (chi-square of 6 if the images are
  /// of one moment and the rig is right). Empty if one camera alone does not determine a pose.
  std::optional<double> sides_apart;
  bool is_valid = false;  // enough matches for a pose
};

enum class Sides { both, left, right };

/// `start` may be off by some 8 degrees and 20 mm. Uses both images, or one camera's only.
RecoveryPose fitRecoveryPose(const cameras::StereoRig& rig, const SkinPoints& points, const SkinView& then,
                             const RecoveryPictures& now, const Eigen::Isometry3d& start,
                             Sides sides = Sides::both);

}  // namespace facenav::head_tracking
