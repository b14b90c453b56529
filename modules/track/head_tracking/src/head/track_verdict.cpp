#include "track_verdict.h"

#include "facenav/anatomy/head_norms.h"
#include "facenav/geometry/normal_equations.h"
#include "facenav/geometry/rotation.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>

namespace facenav::head_tracking {
namespace {

// Largest predicted standard error of a pose that is shown, at the cortex: a fifth of the error of a wrong
// pose, 3 mm.
constexpr double kWorstSigma_mm = 0.6;
constexpr double kMomentFactor = 5.0 / 3.0;  // factor for a face found again: a third of 3 mm
constexpr double kWorstScale = 6.0;

struct Count {
  std::size_t visible = 0, good = 0;
  double share() const { return visible > 0 ? double(good) / double(visible) : 0.0; }
  bool isEnough() const { return good >= kFewestPatches && share() >= kLeastGoodShare; }
};

Count count(const PoseFit& fit, int camera) {
  Count n;
  for (const auto& measurement : fit.measurements) {
    if (!measurement[camera].is_visible || measurement[camera].expected_ncc < 0.5f) continue;
    ++n.visible;
    n.good += measurement[camera].isGood();
  }
  return n;
}

// Covariance predicted by the patches' own errors, plus what the disagreement between parts of the face shows
// (a cluster-robust covariance for errors common to a part, Liang & Zeger 1986).
Matrix6d covarianceOf(const PoseFit& fit) {
  if (!(principalAxes(fit.information).values(0) > 1e-9)) return Matrix6d::Identity() * 1e6;
  Matrix6d rotate = Matrix6d::Zero();  // from Head's axes to Camera's
  rotate.topLeftCorner<3, 3>() = fit.motion.linear();
  rotate.bottomRightCorner<3, 3>() = fit.motion.linear();
  const Matrix6d inverse = inverseOf(fit.information);
  const double freedom = std::max(1.0, double(fit.regions - 6));
  const Matrix6d seen = double(fit.regions) / freedom * inverse * fit.pull * inverse;
  return rotate * (inverse + seen) * rotate.transpose();
}

double sigmaAtCortex_mm(const Matrix6d& covariance) {
  Eigen::Matrix<double, 3, 6> carry;
  carry << -skew(Eigen::Vector3d(0, 0, anatomy::kFaceToCortex_mm)), Eigen::Matrix3d::Identity();
  return std::sqrt((carry * covariance * carry.transpose()).trace());
}

}  // namespace

Verdict judge(const PatchModel& model, const PoseFit& fit, const Matrix6d& key_covariance,
              bool is_of_moment) {
  Verdict verdict;
  const Count left = count(fit, 0), right = count(fit, 1);
  verdict.good_share = {left.share(), right.share()};
  verdict.covariance = model.variance_factor * covarianceOf(fit) + key_covariance;
  const double factor = std::sqrt(model.variance_factor) * (is_of_moment ? kMomentFactor : 1.0);
  if (!left.isEnough() && !right.isEnough())
    verdict.lost = LostReason::few_features;
  else if (!left.isEnough() || !right.isEnough())
    verdict.lost = LostReason::camera;
  else if (!fit.is_settled || fit.scale > kWorstScale ||
           sigmaAtCortex_mm(verdict.covariance) > factor * kWorstSigma_mm)
    verdict.lost = LostReason::high_residual;
  verdict.quality = std::clamp(std::min(left.share(), right.share()) / 0.9, 0.0, 1.0);
  return verdict;
}

}  // namespace facenav::head_tracking
