#include "thin_plate.h"

#include <Eigen/LU>
#include <cmath>

namespace facenav::room {
namespace {

double kernel(double squared) { return squared > 0.0 ? squared * std::log(squared) : 0.0; }

}  // namespace

ThinPlate::ThinPlate(const std::vector<Eigen::Vector2d>& from, const std::vector<Eigen::Vector2d>& to,
                     double stiffness)
    : knots_(from) {
  const auto n = Eigen::Index(from.size());
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + 3, n + 3);
  Eigen::MatrixX2d goal = Eigen::MatrixX2d::Zero(n + 3, 2);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) system(i, j) = kernel((from[i] - from[j]).squaredNorm());
    system(i, i) += stiffness;
    system.block<1, 3>(i, n) << 1.0, from[i].x(), from[i].y();
    goal.row(i) = to[i].transpose();
  }
  system.block(n, 0, 3, n) = system.block(0, n, n, 3).transpose();
  weights_ = system.partialPivLu().solve(goal);
}

Eigen::Vector2d ThinPlate::at(const Eigen::Vector2d& p) const {
  const auto n = Eigen::Index(knots_.size());
  Eigen::Vector2d sum = weights_.row(n) + p.x() * weights_.row(n + 1) + p.y() * weights_.row(n + 2);
  for (Eigen::Index i = 0; i < n; ++i)
    sum += kernel((p - knots_[i]).squaredNorm()) * weights_.row(i).transpose();
  return sum;
}

}  // namespace facenav::room
