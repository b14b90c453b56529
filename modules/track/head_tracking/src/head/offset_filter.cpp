#include "offset_filter.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace facenav::head_tracking {
namespace {

constexpr double kSharedError_px = 0.03;  // error common to the disparities: shape, glints
constexpr double kSharedFor_s = 0.1;      // frames closer together share it
constexpr double kDrift_s2_per_s = 4e-8;  // two free clocks: 0.2 ms in a second
constexpr double kContradiction = 4.0;    // standard deviations
constexpr int kBelieved = 20;             // consecutive contradictions after which the offset has jumped
constexpr double kCertain = 2.0;          // standard deviations

struct Measurement {
  double offset_s = 0.0, variance_s2 = 0.0;
  Vector6d by_offset;  // change of the pose with the offset
};

// Least squares for pose and offset together. All patches have the spread of the fit's residuals.
std::optional<Measurement> measure(const PatchLevel& level, const PoseFit& fit, const Vector6d& velocity,
                                   const Vector6d& allowed) {
  Matrix6d h = Matrix6d::Zero();
  Vector6d g = Vector6d::Zero(), cross = Vector6d::Zero();
  double along = 0.0, along_d = 0.0, d2 = 0.0, weights = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < fit.measurements.size(); ++i) {
    const auto& measurements = fit.measurements[i];
    if (!measurements[0].isGood() || !measurements[1].isGood()) continue;
    ++count;
    const double w = std::min(measurements[0].weight, measurements[1].weight);
    for (int c = 0; c < 2; ++c) {
      const auto& j = level.patches[i].view[c].jacobian;
      Eigen::Vector2d d = measurements[c].displacement.cast<double>();
      if (c == 1) d += j * allowed;
      h += w * j.transpose() * j;
      g += w * j.transpose() * d;
      d2 += w * d.squaredNorm();
      weights += w;
      if (c == 0) continue;
      const Eigen::Vector2d u = j * velocity;
      cross += w * j.transpose() * u;
      along += w * u.squaredNorm();
      along_d += w * u.dot(d);
    }
  }
  if (count < int(kFewestPatches)) return std::nullopt;
  const Eigen::LDLT<Matrix6d> solver(h);
  const Vector6d by_offset = solver.solve(cross);
  const double information = along - cross.dot(by_offset);  // with the pose free
  if (!(information > 1e-9 * along) || !(information > 0.0)) return std::nullopt;
  const double score = along_d - cross.dot(solver.solve(g));
  const double left_over = d2 - g.dot(solver.solve(g)) - score * score / information;
  const double spread_px2 = std::max(1e-4, left_over / (2.0 * weights));
  return Measurement{score / information,
                     spread_px2 / information + kSharedError_px * kSharedError_px * weights / information,
                     -by_offset};
}

}  // namespace

double OffsetFilter::sigma_s() const { return std::sqrt(variance_s2_); }

double OffsetFilter::late_s() const {
  const double limit_s2 = kCertain * kCertain * variance_s2_;
  const double share = limit_s2 / (offset_s_ * offset_s_);
  return offset_s_ * offset_s_ > limit_s2 ? offset_s_ * (1.0 - share * share) : 0.0;
}

void OffsetFilter::state(double late_s) {
  constexpr double kSmooth = 0.05;  // weight of a frame: stamps jitter by 1 ms, clocks drift by far less
  if (is_statement_wrong_) return;
  if (!stated_s_) {
    stated_s_ = offset_s_ = late_s;
    variance_s2_ = kStated_s * kStated_s;
    return;
  }
  const double step_s = kSmooth * (late_s - *stated_s_);
  *stated_s_ += step_s, offset_s_ += step_s;
}

void OffsetFilter::add(const PatchLevel& level, const PoseFit& fit, const Vector6d& velocity,
                       const Vector6d& allowed, double since_s) {
  variance_s2_ = std::min(prior_s() * prior_s(), variance_s2_ + kDrift_s2_per_s * since_s);
  const auto measured = measure(level, fit, velocity, allowed);
  by_offset_ = measured ? measured->by_offset : Vector6d(Vector6d::Zero());
  if (!measured) return;
  const double variance = measured->variance_s2 * std::max(1.0, kSharedFor_s / std::max(1e-3, since_s));
  const double innovation = measured->offset_s - offset_s_, expected = variance_s2_ + variance;
  if (innovation * innovation > kContradiction * kContradiction * expected) {
    if (++contradicted_ < kBelieved) return;
    const bool was_stated = stated_s_.has_value();
    reset();
    is_statement_wrong_ = was_stated;
    return;
  }
  contradicted_ = 0;
  const double gain = variance_s2_ / expected;
  offset_s_ += gain * innovation;
  variance_s2_ *= 1.0 - gain;
}

}  // namespace facenav::head_tracking
