#pragma once
// StereoConsistency: how the right camera stands to the left one, from the skin patches alone. Each camera by
// itself shows the known face at a pose: size gives distance, perspective gives the turn. Where the cameras
// stand to each other as they did at the key frame, both poses are the same. The unknowns are xi, the head's
// motion left over by the fit, and zeta, a further motion that only the right camera sees.
//
// Pitch, roll and vertical shift move patches across the epipolar lines. Yaw moves them along the lines, like
// a nearer head, but the head's size does not change with it. Errors that both images share (shape, light,
// expression) change the size too: the disagreement between the parts of the face tells how much.

#include <optional>
#include <vector>

#include "facenav/geometry/rotation.h"

namespace facenav::head_tracking {

/// Head, (rad, mm) about the model's centre.
struct SidesFit {
  Vector6d zeta = Vector6d::Zero();
  Matrix6d covariance = Matrix6d::Zero();
  Matrix6d xi_by_zeta = Matrix6d::Zero();  // what a fit of one pose to both images makes of it
};

class StereoConsistency {
 public:
  explicit StereoConsistency(int regions) : regions_(std::size_t(regions)) {}

  /// An observation of two values: by_both * xi + by_right * zeta = off, with this weight.
  void add(int region, const Eigen::Matrix<float, 2, 6>& by_both, const Eigen::Matrix<float, 2, 6>& by_right,
           const Eigen::Vector2f& off, const Eigen::Matrix2f& weight);
  /// Nothing where too few parts of the face are seen.
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
