#include "facenav/efield/built_in_coils.h"

#include <Eigen/Dense>
#include <cmath>

#include "facenav/core/error.h"

namespace facenav::efield {
namespace {

constexpr double kCasing_mm = 3;
constexpr double kMetresPerMm = 1e-3;

/// Moment of order 2k of the spiral's sheet of dipoles: sum over the turns of the integral of r^2k over the
/// disc inside the turn, mean over the wire's width. m^(2k + 2).
double discMoment(const Spiral& spiral, int k) {
  double sum = 0;
  for (int turn = 0; turn < spiral.turns; ++turn) {
    const double inner = kMetresPerMm * (spiral.radius_mm(turn) - spiral.width_mm / 2);
    const double outer = kMetresPerMm * (spiral.radius_mm(turn) + spiral.width_mm / 2);
    sum += M_PI / (k + 1) * (std::pow(outer, 2 * k + 3) - std::pow(inner, 2 * k + 3)) /
           ((2 * k + 3) * (outer - inner));
  }
  return sum;
}

struct Rings {
  double centre_moment = 0;
  std::vector<double> radii_m, moments;  // moment: that of the whole ring
};

/// Gauss-Radau rule in r^2 with one node at 0: `count` rings and the centre give 2 count + 1 moments.
Rings ringsOf(const Spiral& spiral, int count) {
  const double scale = std::pow(kMetresPerMm * spiral.radius_mm(spiral.turns - 1), 2);
  std::vector<double> mu;
  for (int k = 0; k <= 2 * count; ++k) mu.push_back(discMoment(spiral, k) / std::pow(scale, k));
  Eigen::MatrixXd hankel(count, count);
  Eigen::VectorXd right(count);
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) hankel(i, j) = mu[std::size_t(i + j + 1)];
    right[i] = -mu[std::size_t(i + count + 1)];
  }
  const Eigen::VectorXd polynomial = hankel.fullPivLu().solve(right);
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(count, count);
  for (int i = 0; i < count; ++i) {
    if (i > 0) companion(i, i - 1) = 1;
    companion(i, count - 1) = -polynomial[i];
  }
  Eigen::VectorXd nodes = companion.eigenvalues().real();
  std::sort(nodes.begin(), nodes.end());
  Eigen::MatrixXd powers(count, count);
  Eigen::VectorXd wanted(count);
  for (int k = 0; k < count; ++k) {
    for (int i = 0; i < count; ++i) powers(k, i) = std::pow(nodes[i], k + 1);
    wanted[k] = mu[std::size_t(k + 1)];
  }
  const Eigen::VectorXd weights = powers.fullPivLu().solve(wanted);
  Rings rings;
  rings.centre_moment = mu[0] - weights.sum();
  for (int i = 0; i < count; ++i) {
    rings.radii_m.push_back(std::sqrt(nodes[i] * scale));
    rings.moments.push_back(weights[i]);
  }
  return rings;
}

}  // namespace

std::vector<Spiral> figureEightWinding() {
  Spiral wing;
  wing.turns = 9;
  wing.width_mm = 1;
  wing.height_mm = 7;
  wing.first_radius_mm = 26 + wing.width_mm / 2;
  wing.pitch_mm = (44 - 26 - wing.width_mm) / (wing.turns - 1);
  wing.centre_mm = {44, 0, -kCasing_mm - wing.height_mm / 2};
  wing.sense = -1;
  Spiral other = wing;
  other.centre_mm.x() = -wing.centre_mm.x();
  other.sense = 1;
  return {wing, other};
}

std::vector<Spiral> roundWinding() {
  Spiral coil;
  coil.turns = 14;
  coil.width_mm = 1.75;
  coil.height_mm = 7;
  coil.first_radius_mm = 33 + coil.width_mm / 2;
  coil.pitch_mm = (61.5 - 33 - coil.width_mm) / (coil.turns - 1);
  coil.centre_mm = {0, 0, -kCasing_mm - coil.height_mm / 2};
  coil.sense = -1;
  return {coil};
}

CoilDipoles matchedDipoles(const std::vector<Spiral>& spirals, int rings, int dipoles_a_ring, int layers) {
  if (rings < 1 || rings > 8 || layers < 1 || layers > 2)
    throw Error("a winding is matched by 1 to 8 rings in 1 or 2 layers", std::to_string(rings));
  const Eigen::Index each = layers * (1 + rings * dipoles_a_ring);
  CoilDipoles coil;
  coil.positions_mm.resize(3, each * Eigen::Index(spirals.size()));
  coil.moments_Am2.setZero(3, coil.positions_mm.cols());
  Eigen::Index at = 0;
  const auto put = [&](const Eigen::Vector3d& place_mm, double moment) {
    coil.positions_mm.col(at) = place_mm;
    coil.moments_Am2(2, at++) = moment;
  };
  for (const auto& spiral : spirals) {
    const Rings matched = ringsOf(spiral, rings);
    for (int layer = 0; layer < layers; ++layer) {
      // Two layers have the second moment of the wire's height.
      const double above_mm = layers == 1 ? 0 : (layer - 0.5) * spiral.height_mm / std::sqrt(3.0);
      const Eigen::Vector3d centre_mm = spiral.centre_mm + Eigen::Vector3d(0, 0, above_mm);
      const double share = double(spiral.sense) / layers;
      put(centre_mm, share * matched.centre_moment);
      for (std::size_t ring = 0; ring < matched.radii_m.size(); ++ring)
        for (int i = 0; i < dipoles_a_ring; ++i) {
          const double angle = 2 * M_PI * (i + (ring % 2 == 0 ? 0.0 : 0.5)) / dipoles_a_ring;
          const double radius_mm = matched.radii_m[ring] / kMetresPerMm;
          put(centre_mm + radius_mm * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0),
              share * matched.moments[ring] / dipoles_a_ring);
        }
    }
  }
  return coil;
}

CoilDipoles figureEight70() {
  auto coil = matchedDipoles(figureEightWinding(), 2, 10, 1);
  coil.name = "figure-8 70 mm (built in)";
  return coil;
}

CoilDipoles roundCoil() {
  auto coil = matchedDipoles(roundWinding(), 6, 8, 2);
  coil.name = "round 90 mm (built in)";
  return coil;
}

}  // namespace facenav::efield
