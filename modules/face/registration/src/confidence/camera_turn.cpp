#include "camera_turn.h"

#include <algorithm>
#include <cmath>

#include "cloud/cloud_sampling.h"
#include "facenav/core/error.h"
#include "facenav/core/robust_statistics.h"
#include "fit/robust_fit.h"
#include "fit/skin_likelihood.h"
#include "search/start_search.h"

namespace facenav::registration {
namespace {

constexpr int kMostFits = 7;
constexpr double kLeftOver = 0.3;                       // residual turn, in standard errors
constexpr double kFirstSlope = 0.4, kLeastSlope = 0.2;  // estimate relative to the true turn
// Standard deviation of the turn that differences of size and skin between scan and live head imitate, beyond
// the misfit model, with dense dots. Larger widens the bound and detects fewer turns.
constexpr double kScan_rad = 0.05 * kRadPerDeg;
// Standard deviation without dense dots (start.right->sigma_rad > 0), where the points' own deviation is
// added.
constexpr double kScanBesideDeviation_rad = 0.03 * kRadPerDeg;
constexpr double kLessLikely = 3.0;  // log odds of 20 to 1: a turn that fits worse by this is none
constexpr double kLongestStep_rad = 0.15 * kRadPerDeg, kMostTurn_rad = 0.6 * kRadPerDeg;

/// Weighted mean of two measurements. If they contradict each other, one of them is wrong (a print at another
/// size, a scan at another scale), and a mean could hide a turn. Then the one that is more standard errors
/// from zero is used.
CameraTurn fused(const CameraTurn& a, const CameraTurn& b) {
  if (std::abs(a.rad - b.rad) > kSignificant * std::hypot(a.sigma_rad, b.sigma_rad))
    return std::abs(a.rad) * b.sigma_rad > std::abs(b.rad) * a.sigma_rad ? a : b;
  const double of_a = 1.0 / (a.sigma_rad * a.sigma_rad), of_b = 1.0 / (b.sigma_rad * b.sigma_rad);
  return {(of_a * a.rad + of_b * b.rad) / (of_a + of_b), 1.0 / std::sqrt(of_a + of_b)};
}

/// Fits the turned cloud, from a pose near it.
std::optional<FinalFit> fitTurned(const ScalpField& scalp, const PointCloud<Camera>& face,
                                  const AlignmentStart& start, const Eigen::Isometry3d& near) {
  try {
    const RobustFit robust = fitFace(scalp, face, near, start.noise_mm);
    return correct(scalp, face, evenPoints(scalp, face, robust), robust.mri_T_camera, robust.limit_mm, start);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// A turn that was tried, and what the fit there says.
struct TriedTurn {
  double at_rad = 0.0;
  CameraTurn left;  // remaining turn at `at_rad`
  double log_likelihood = 0.0;
};

Eigen::Vector3d middleOf(const PointCloud<Camera>& face) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const auto& p : face.points_mm) middle += p / double(face.size());
  return middle;
}

/// Turn of the right camera that changes the size of a face there by this factor.
double turnOf(const TurnableCamera& right, const Eigen::Vector3d& at_mm, double size) {
  return (size - 1.0) * at_mm.squaredNorm() / right.displacement(at_mm).dot(at_mm);
}

}  // namespace

PointCloud<Camera> turnedBack(PointCloud<Camera> face, const TurnableCamera& right, double rad) {
  const Eigen::Matrix3d back = expRotation(-rad * right.axis.v);
  for (auto& p : face.points_mm) {
    const Eigen::Vector3d ray = p.normalized(), seen = back * (p - right.centre.mm);
    const double length_mm =
        right.centre.mm.cross(seen).dot(right.axis.v) / ray.cross(seen).dot(right.axis.v);
    if (std::isfinite(length_mm) && length_mm > 0) p = length_mm * ray;
  }
  return face;
}

std::optional<CameraTurn> settledTurn(const ScalpField& scalp, const PointCloud<Camera>& face,
                                      const AlignmentStart& start, const FinalFit& first, double size) {
  if (!start.right || !first.posterior.turn) return std::nullopt;
  const Eigen::Vector3d middle_mm = middleOf(face);
  const std::vector<int> skin =
      thinOut(face, nearHead(scalp, face, finitePoints(face), first.mri_T_camera, 30.0), 5.0, 1500);
  const auto logLikelihood = [&](const PointCloud<Camera>& cloud, const Eigen::Isometry3d& mri_T_camera) {
    return SkinLikelihood(scalp, cloud, skin,
                          start.noise_mm)(FieldFitter(scalp, cloud, skin).match(mri_T_camera));
  };
  const auto tryTurn = [&](double rad) -> std::optional<TriedTurn> {
    const PointCloud<Camera> turned = turnedBack(face, *start.right, rad);
    const auto fit = fitTurned(scalp, turned, start,
                               first.mri_T_camera * Eigen::Translation3d(middle_mm - middleOf(turned)));
    if (!fit || !fit->posterior.turn) return std::nullopt;
    return TriedTurn{rad, *fit->posterior.turn, logLikelihood(turned, fit->mri_T_camera)};
  };
  TriedTurn best{0.0, *first.posterior.turn, logLikelihood(face, first.mri_T_camera)};
  if (size != 1.0) {
    const auto tried = tryTurn(turnOf(*start.right, middle_mm, size));
    if (tried && tried->log_likelihood > best.log_likelihood) best = *tried;
  }
  double slope = kFirstSlope;
  for (int fits = 1; fits < kMostFits && std::abs(best.left.rad) > kLeftOver * best.left.sigma_rad; ++fits) {
    const double step_rad = std::clamp(best.left.rad / slope, -kLongestStep_rad, kLongestStep_rad);
    if (std::abs(best.at_rad + step_rad) > kMostTurn_rad) break;
    const auto tried = tryTurn(best.at_rad + step_rad);
    if (!tried || tried->log_likelihood < best.log_likelihood - kLessLikely) break;
    slope = std::clamp((best.left.rad - tried->left.rad) / step_rad, kLeastSlope, 1.0);
    best = *tried;
  }
  const double scan_rad = start.right->sigma_rad > 0 ? kScanBesideDeviation_rad : kScan_rad;
  const CameraTurn by_face{best.at_rad + best.left.rad,
                           std::hypot(best.left.sigma_rad, scan_rad, start.right->sigma_rad)};
  return start.known_turn ? fused(by_face, *start.known_turn) : by_face;
}

}  // namespace facenav::registration
