#pragma once
// The head's pose from skin matches (skin_points.h): robust least squares over both cameras, coarse to fine.
// Skin that moves over the bone counts by how far it usually does (skin_mobility.h), outliers by Student's t
// (Lange, Little, Taylor 1989). At the finest level the skin's motion is estimated with the pose
// (skin_field.h), and the covariance includes it.

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "facenav/geometry/rotation.h"
#include "skin_points.h"

namespace facenav::head_tracking {

struct RecoveryPose {
  Eigen::Isometry3d camera_T_head = Eigen::Isometry3d::Identity();
  /// Of xi = (w rad, v mm) as HeadPose's, about the points' centre, Camera's axes.
  Matrix6d covariance = Matrix6d::Identity() * 1e6;
  /// The same, of what no picture shows: rig, shape and what lies between two sessions. Not within
  /// `covariance`.
  Matrix6d unseen_covariance = Matrix6d::Zero();
  std::vector<SkinMatch> matches;   // of the last search; offsets are from the pose before the last step
  std::vector<double> residual_px;  // of each match, after the last step
  /// How far both cameras, each alone, put the head from each other: squared, by their covariance (chi-square
  /// of 6 where the pictures are of one moment and the rig holds). Nothing where one alone fixes no pose.
  std::optional<double> sides_apart;
  bool is_valid = false;  // enough matches for a pose
};

enum class Sides { both, left, right };

/// From `start`, true to some 8 degrees and 20 mm; from both pictures, or from one camera's alone.
RecoveryPose fitRecoveryPose(const cameras::StereoRig& rig, const SkinPoints& points, const SkinView& then,
                             const RecoveryPictures& now, const Eigen::Isometry3d& start,
                             Sides sides = Sides::both);

}  // namespace facenav::head_tracking
