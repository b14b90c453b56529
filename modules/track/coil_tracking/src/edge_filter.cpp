#include "edge_filter.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

namespace facenav::coil_tracking {
namespace {

constexpr std::array<double, 6> kBlurs_px{0.55, 0.75, 1.0, 1.4, 1.9, 2.6};
using Table = std::array<std::array<EdgeWeights, kMostTaps + 1>, kBlurs_px.size()>;

double step(double u) { return 0.5 * std::erfc(-u / std::sqrt(2.0)); }
double bell(double u) { return std::exp(-0.5 * u * u) / std::sqrt(2.0 * M_PI); }

EdgeWeights::AtPhase solve(int taps, double blur_px, double phase_px) {
  const int rows = 2 * taps + 1, columns = taps >= 3 ? 4 : 3;
  const double sigma = std::hypot(blur_px, std::sqrt(1.0 / 12.0));  // a pixel is a box of 1 px
  Eigen::MatrixXd design(rows, columns);
  for (int row = 0; row < rows; ++row) {
    const double u = (row - taps - phase_px) / sigma;
    design(row, 0) = 1.0;
    design(row, 1) = step(u);
    design(row, 2) = bell(u) / sigma;
    if (columns == 4) design(row, 3) = -u * bell(u) / sigma;
  }
  const Eigen::MatrixXd inverse = (design.transpose() * design).ldlt().solve(design.transpose());
  EdgeWeights::AtPhase weights{};
  for (int row = 0; row < rows; ++row) {
    weights.contrast[row] = float(inverse(1, row));
    weights.a[row] = float(inverse(2, row));
  }
  return weights;
}

const Table& table() {
  static const Table made = [] {
    Table t{};
    for (std::size_t blur = 0; blur < kBlurs_px.size(); ++blur)
      for (int taps = kFewestTaps; taps <= kMostTaps; ++taps) {
        EdgeWeights& weights = t[blur][taps];
        weights.taps = taps;
        weights.reach_px = float(1.5 + kBlurs_px[blur]);
        for (int phase = 0; phase <= EdgeWeights::kPhases; ++phase)
          weights.phases[phase] = solve(taps, kBlurs_px[blur], double(phase) / EdgeWeights::kPhases - 0.5);
      }
    return t;
  }();
  return made;
}

std::size_t nearestBlur(double blur_px) {
  std::size_t best = 0;
  while (best + 1 < kBlurs_px.size() && blur_px > 0.5 * (kBlurs_px[best] + kBlurs_px[best + 1])) ++best;
  return best;
}

}  // namespace

const EdgeWeights& edgeWeights(int taps, double blur_px) { return table()[nearestBlur(blur_px)][taps]; }

std::optional<EdgePoint> locateEdge(const EdgeWeights& weights, const std::uint8_t* first,
                                    std::ptrdiff_t step, double place_px, bool is_black_after,
                                    double least_contrast) {
  const int centre = int(place_px + 0.5);  // places are positive
  const double in_phases = (place_px - centre + 0.5) * EdgeWeights::kPhases;
  const int phase = int(in_phases + 0.5);
  const EdgeWeights::AtPhase& w = weights.phases[phase];
  float contrast = 0, a = 0;
  const std::uint8_t* pixel = first + (centre - weights.taps) * step;
  for (int k = 0; k <= 2 * weights.taps; ++k, pixel += step) {
    const float grey = *pixel;
    contrast += w.contrast[k] * grey;
    a += w.a[k] * grey;
  }
  const double fall = is_black_after ? -contrast : contrast;
  if (!(fall >= least_contrast)) return std::nullopt;
  const double offset_px = (phase - in_phases) / EdgeWeights::kPhases - a / contrast;
  if (!(std::abs(offset_px) <= weights.reach_px)) return std::nullopt;
  return EdgePoint{offset_px, fall};
}

std::optional<EdgePoint> searchEdge(const std::uint8_t* first, std::ptrdiff_t step, double place_px,
                                    bool is_black_after, int reach_px, double least_contrast) {
  const int centre = int(std::floor(place_px + 0.5));
  const auto fall = [&](int x) {  // from two pixels before x to two after
    const std::uint8_t* p = first + x * step;
    const int sum = int(p[-2 * step]) + int(p[-step]) - int(p[step]) - int(p[2 * step]);
    return is_black_after ? sum : -sum;
  };
  int best = centre, most = 0;
  for (int x = centre - reach_px; x <= centre + reach_px; ++x) {
    const int here = fall(x);
    if (here > most) {
      most = here;
      best = x;
    }
  }
  if (0.5 * most < least_contrast) return std::nullopt;
  const double before = fall(best - 1), after = fall(best + 1), bend = before + after - 2.0 * most;
  const double part = bend < 0 ? std::clamp(0.5 * (before - after) / bend, -0.5, 0.5) : 0.0;
  return EdgePoint{best + part - place_px, 0.5 * most};
}

}  // namespace facenav::coil_tracking
