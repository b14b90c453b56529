#include "facenav/efield/thinned_coil.h"

#include <cmath>
#include <vector>

#include "facenav/efield/coil_source.h"
#include "facenav/efield/primary_field.h"
#include "layer_fit.h"

namespace facenav::efield {
namespace {

constexpr double kScalp_mm = 92;                 // radius of the sphere in which the error is measured
constexpr double kPlane_mm = 10;                 // below the casing
constexpr double kMargin_mm = 45, kStep_mm = 5;  // of the plane's points
constexpr int kRounds = 12;                      // of the grouping
constexpr double kRidge = 1e-10;
// Dipoles weaker than this share of the strongest do not place the groups; the best of both is taken.
constexpr double kWeakest[] = {0.05, 0};

/// Starts with the strongest dipole, then always takes the one farthest from those taken.
Eigen::Matrix3Xd spreadOver(const Eigen::Matrix3Xd& places_mm, const Eigen::VectorXd& strength, int count) {
  Eigen::Matrix3Xd chosen(3, count);
  Eigen::Index next = 0;
  strength.maxCoeff(&next);
  Eigen::VectorXd nearest2 = Eigen::VectorXd::Constant(places_mm.cols(), 1e300);
  for (int c = 0; c < count; ++c) {
    chosen.col(c) = places_mm.col(next);
    for (Eigen::Index k = 0; k < places_mm.cols(); ++k)
      nearest2[k] = std::min(nearest2[k], (places_mm.col(k) - chosen.col(c)).squaredNorm());
    nearest2.maxCoeff(&next);
  }
  return chosen;
}

/// The dipoles of at least a share of the strongest one's moment.
CoilDipoles strongOf(const CoilDipoles& coil, double share) {
  const Eigen::VectorXd strength = coil.moments_Am2.colwise().norm().transpose();
  CoilDipoles strong = coil;
  Eigen::Index count = 0;
  for (Eigen::Index k = 0; k < strength.size(); ++k) {
    if (strength[k] < share * strength.maxCoeff()) continue;
    strong.positions_mm.col(count) = coil.positions_mm.col(k);
    strong.moments_Am2.col(count++) = coil.moments_Am2.col(k);
  }
  strong.positions_mm.conservativeResize(3, count);
  strong.moments_Am2.conservativeResize(3, count);
  return strong;
}

/// Middles of `count` groups of near dipoles, weighted by their strength.
Eigen::Matrix3Xd groupMiddles(const CoilDipoles& coil, int count) {
  const Eigen::VectorXd strength = coil.moments_Am2.colwise().norm().transpose();
  Eigen::Matrix3Xd middles = spreadOver(coil.positions_mm, strength, count);
  for (int round = 0; round < kRounds; ++round) {
    Eigen::Matrix3Xd sums = Eigen::Matrix3Xd::Zero(3, count);
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(count);
    for (Eigen::Index k = 0; k < coil.positions_mm.cols(); ++k) {
      const Eigen::Vector3d place_mm = coil.positions_mm.col(k);
      Eigen::Index group = 0;
      (middles.colwise() - place_mm).colwise().squaredNorm().minCoeff(&group);
      sums.col(group) += strength[k] * place_mm;
      weights[group] += strength[k];
    }
    for (int c = 0; c < count; ++c)
      if (weights[c] > 0) middles.col(c) = sums.col(c) / weights[c];
  }
  return middles;
}

CoilDipoles fitted(const CoilDipoles& coil, const Eigen::Matrix3Xd& places_mm) {
  const Eigen::Vector2d low = coil.positions_mm.topRows<2>().rowwise().minCoeff().array() - kMargin_mm;
  const Eigen::Vector2d high = coil.positions_mm.topRows<2>().rowwise().maxCoeff().array() + kMargin_mm;
  const Eigen::Matrix3Xd points = planePoints(low, high, kPlane_mm, kStep_mm);
  Eigen::MatrixXd matrix(points.cols(), 3 * places_mm.cols());
  CoilDipoles one;
  for (Eigen::Index c = 0; c < matrix.cols(); ++c) {
    one.positions_mm = places_mm.col(c / 3);
    one.moments_Am2 = Eigen::Vector3d::Unit(c % 3);
    matrix.col(c) = fluxOf(one, points);
  }
  const Eigen::VectorXd moments = leastSquares(std::move(matrix), fluxOf(coil, points), kRidge);
  CoilDipoles thinned = coil;
  thinned.positions_mm = places_mm;
  thinned.moments_Am2 = Eigen::Map<const Eigen::Matrix3Xd>(moments.data(), 3, places_mm.cols());
  return thinned;
}

}  // namespace

double relativeErrorInSphere(const CoilDipoles& coil, const CoilDipoles& reference) {
  const RigidTransform<Mri, frames::Coil> pose;
  const Eigen::Vector3d centre_mm(0, 0, kScalp_mm);
  double worst = 0;
  for (const double depth_mm : {12.0, 16.0, 20.0, 30.0, 40.0}) {
    std::vector<Eigen::Vector3d> shell;
    for (double tilt = 0; tilt < 1.1; tilt += 0.1)
      for (int i = 0; i < 24; ++i) {
        const double angle = 2 * M_PI * i / 24;
        const Eigen::Vector3d out(std::sin(tilt) * std::cos(angle), std::sin(tilt) * std::sin(angle),
                                  -std::cos(tilt));
        shell.push_back(centre_mm + (kScalp_mm - depth_mm) * out);
      }
    const Eigen::Map<const Eigen::Matrix3Xd> points(shell[0].data(), 3, Eigen::Index(shell.size()));
    const Eigen::Matrix3Xd wanted = sphereField(reference, pose, centre_mm, points);
    const Eigen::Matrix3Xd given = sphereField(coil, pose, centre_mm, points);
    worst = std::max(worst, (given - wanted).norm() / wanted.norm());
  }
  return worst;
}

ThinnedCoil thinnedCoil(const CoilDipoles& coil, int most) {
  const bool is_few = coil.positions_mm.cols() <= most;
  if (is_few || coil.positions_mm.row(2).maxCoeff() > 0) return {coil, 0};
  ThinnedCoil best{coil, kLargestThinningError};
  bool is_thinned = false;
  for (const double share : kWeakest) {
    const CoilDipoles strong = strongOf(coil, share);
    const int groups = std::min(most, int(strong.positions_mm.cols()));
    const CoilDipoles thinned = fitted(coil, groupMiddles(strong, groups));
    const double error = relativeErrorInSphere(thinned, coil);
    if (!(error <= best.relative_error)) continue;
    best = {thinned, error};
    is_thinned = true;
  }
  if (!is_thinned) best.relative_error = 0;
  return best;
}

}  // namespace facenav::efield
