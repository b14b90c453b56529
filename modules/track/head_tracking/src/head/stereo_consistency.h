#pragma once
// StereoConsistency: pose of the right camera relative to the left one, from the skin patches alone. Each
// camera alone determines a pose of the known face: size gives distance, perspective gives the turn. If the
// cameras are positioned as at the key frame, both poses are the same. The unknowns are xi, the head's motion
// left over by the fit, and zeta, a further motion that only the right camera sees.
//
// Pitch, roll and vertical shift move patches across the epipolar lines. Yaw moves them along the lines, like
// a nearer head, but the head's size does not change with it. Errors that both images share (shape, light,
// expression) change the size too; the disagreement between the parts of the face shows how much.

#include <optional>
#include <vector>

#include "facenav/geometry/rotation.h"

namespace facenav::head_tracking {

/// Motion zeta in Head, (rad, mm) about the model's centre, with covariance.
struct SidesFit {
  Vector6d zeta = Vector6d::Zero();
  Matrix6d covariance = Matrix6d::Zero();
  Matrix6d xi_by_zeta = Matrix6d::Zero();  // apparent xi of a fit of one pose to both images
};

class StereoConsistency {
 public:
  explicit StereoConsistency(int regions) : regions_(std::size_t(regions)) {}

  /// Adds an observation of two values with this weight: by_both * xi + by_right * zeta = off.
  void add(int region, const Eigen::Matrix<float, 2, 6>& by_both, const Eigen::Matrix<float, 2, 6>& by_right,
           const Eigen::Vector2f& off, const Eigen::Matrix2f& weight);
  /// Solves the observations. Returns nothing if too few parts of the face are visible.
  std::optional<SidesFit> solve() const;

 private:
  struct Sums {
    Eigen::Matrix<float, 12, 12> information = Eigen::Matrix<float, 12, 12>::Zero();
    Eigen::Matrix<float, 12, 1> score = Eigen::Matrix<float, 12, 1>::Zero();
    int count = 0;
  };
  std::vector<Sums> regions_;
};

}  // namespace facenav::head_tracking
