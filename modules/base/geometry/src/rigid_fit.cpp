#include "facenav/geometry/rigid_fit.h"

#include <Eigen/SVD>
#include <cmath>

namespace facenav {
inline namespace geometry {
namespace {

Eigen::Vector3d weightedMean(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& weights) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double total = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double w = weights.empty() ? 1.0 : weights[i];
    sum += w * points[i];
    total += w;
  }
  if (!(total > 0)) throw Error("rigid fit: all weights are zero");
  return sum / total;
}

}  // namespace

RigidFit fitRigidPoints(const std::vector<Eigen::Vector3d>& from, const std::vector<Eigen::Vector3d>& to,
                        const std::vector<double>& weights) {
  FACENAV_EXPECT(from.size() == to.size(), "rigid fit needs corresponding points");
  FACENAV_EXPECT(weights.empty() || weights.size() == from.size(), "rigid fit needs one weight per pair");
  if (from.size() < 3) throw Error("rigid fit: fewer than 3 point pairs");
  const Eigen::Vector3d from_mean = weightedMean(from, weights), to_mean = weightedMean(to, weights);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < from.size(); ++i)
    covariance +=
        (weights.empty() ? 1.0 : weights[i]) * (to[i] - to_mean) * (from[i] - from_mean).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  if (!(svd.singularValues()(1) > 1e-9 * svd.singularValues()(0)))
    throw Error("rigid fit: the points lie on one line, the rotation is not determined");
  Eigen::Vector3d signs(1, 1, (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1);
  RigidFit fit{Eigen::Isometry3d::Identity(), 0.0};
  fit.to_T_from.linear() = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  fit.to_T_from.translation() = to_mean - fit.to_T_from.linear() * from_mean;
  double squares = 0, total = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double w = weights.empty() ? 1.0 : weights[i];
    squares += w * (fit.to_T_from * from[i] - to[i]).squaredNorm();
    total += w;
  }
  fit.rms_mm = std::sqrt(squares / total);
  return fit;
}

}  // namespace geometry
}  // namespace facenav
