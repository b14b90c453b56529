#include "facenav/geometry/median_pose.h"

#include <algorithm>

#include "facenav/core/error.h"
#include "facenav/geometry/normal_equations.h"
#include "facenav/geometry/rotation.h"

namespace facenav {
inline namespace geometry {
namespace {

constexpr int kMostSteps = 100;
constexpr double kLeast = 1e-6, kSettled = 1e-8;  // mm or rad

}  // namespace

Eigen::Vector3d medianPoint(const std::vector<Eigen::Vector3d>& points) {
  FACENAV_EXPECT(!points.empty(), "a median needs a point");
  Eigen::Vector3d median = Eigen::Vector3d::Zero();
  for (const auto& point : points) median += point / double(points.size());
  for (int step = 0; step < kMostSteps; ++step) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double weights = 0;
    for (const auto& point : points) {
      const double weight = 1 / std::max(kLeast, (point - median).norm());
      sum += weight * (point - median), weights += weight;
    }
    median += sum / weights;
    if ((sum / weights).norm() < kSettled) break;
  }
  return median;
}

Eigen::Matrix3d medianRotation(const std::vector<Eigen::Matrix3d>& rotations) {
  FACENAV_EXPECT(!rotations.empty(), "a median needs a rotation");
  Eigen::Matrix3d sum_of_all = Eigen::Matrix3d::Zero();
  for (const auto& rotation : rotations) sum_of_all += rotation;
  Eigen::Matrix3d median = nearestRotation(sum_of_all);
  for (int step = 0; step < kMostSteps; ++step) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double weights = 0;
    for (const auto& rotation : rotations) {
      const Eigen::Vector3d turn = logRotation(median.transpose() * rotation);
      const double weight = 1 / std::max(kLeast, turn.norm());
      sum += weight * turn, weights += weight;
    }
    const Eigen::Vector3d turn = sum / weights;
    median = median * expRotation(turn);
    if (turn.norm() < kSettled) break;
  }
  return median;
}

}  // namespace geometry
}  // namespace facenav
