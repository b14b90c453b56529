#pragma once
// ThinPlate: the thin-plate spline of the plane (Bookstein 1989), with a stiffness that tolerates noisy
// landmarks.

#include <Eigen/Core>
#include <vector>

namespace facenav::room {

class ThinPlate {
 public:
  /// Maps `from` near `to`; `stiffness` 0 interpolates exactly. At least 3 points, not on a line.
  ThinPlate(const std::vector<Eigen::Vector2d>& from, const std::vector<Eigen::Vector2d>& to,
            double stiffness);
  Eigen::Vector2d at(const Eigen::Vector2d& p) const;

 private:
  std::vector<Eigen::Vector2d> knots_;
  Eigen::MatrixX2d weights_;  // knots, then 1, x, y
};

}  // namespace facenav::room
