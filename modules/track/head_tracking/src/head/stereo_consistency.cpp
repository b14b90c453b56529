#include "stereo_consistency.h"

#include <algorithm>

#include "facenav/geometry/normal_equations.h"

namespace facenav::head_tracking {
namespace {

constexpr int kFewestParts = 14;  // parts of the face: two more than unknowns

using Vector12d = Eigen::Matrix<double, 12, 1>;
using Matrix12d = Eigen::Matrix<double, 12, 12>;

}  // namespace

void StereoConsistency::add(int region, const Eigen::Matrix<float, 2, 6>& by_both,
                            const Eigen::Matrix<float, 2, 6>& by_right, const Eigen::Vector2f& off,
                            const Eigen::Matrix2f& weight) {
  Eigen::Matrix<float, 2, 12> design;
  design << by_both, by_right;
  const Eigen::Matrix<float, 12, 2> weighted = design.transpose() * weight;
  Sums& sums = regions_[std::size_t(region)];
  sums.information.noalias() += weighted * design;
  sums.score.noalias() += weighted * off;
  ++sums.count;
}

std::optional<SidesFit> StereoConsistency::solve() const {
  Matrix12d information = Matrix12d::Zero();
  Vector12d score = Vector12d::Zero();
  int parts = 0;
  for (const Sums& sums : regions_) {
    information += sums.information.cast<double>(), score += sums.score.cast<double>();
    parts += sums.count > 0;
  }
  if (parts < kFewestParts) return std::nullopt;
  const Matrix6d xx = information.topLeftCorner<6, 6>(), zx = information.bottomLeftCorner<6, 6>();
  const Matrix6d xx_inverse = inverseOf(xx);
  const Matrix6d inverse =
      inverseOf(Matrix6d(information.bottomRightCorner<6, 6>() - zx * xx_inverse * zx.transpose()));
  Eigen::Matrix<double, 6, 12> estimator;  // zeta = estimator * score
  estimator << -inverse * zx * xx_inverse, inverse;
  SidesFit fit;
  fit.zeta = estimator * score;
  fit.xi_by_zeta = xx_inverse * zx.transpose();
  Vector12d all;
  all << xx_inverse * (score.head<6>() - zx.transpose() * fit.zeta), fit.zeta;
  Matrix12d pull = Matrix12d::Zero();
  for (const Sums& sums : regions_) {
    if (sums.count == 0) continue;
    const Vector12d own = sums.score.cast<double>() - sums.information.cast<double>() * all;
    pull += own * own.transpose();
  }
  // Errors common to a part of the face (Liang & Zeger 1986), as in the pose's own covariance.
  const double factor = double(parts) / std::max(1.0, double(parts - 12));
  fit.covariance = inverse + factor * estimator * pull * estimator.transpose();
  if (!fit.zeta.allFinite() || !fit.covariance.allFinite()) return std::nullopt;
  return fit;
}

}  // namespace facenav::head_tracking
