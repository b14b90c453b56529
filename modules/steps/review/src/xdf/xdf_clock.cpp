#include "xdf/xdf_clock.h"

#include <algorithm>
#include <cmath>

namespace facenav::steps {
namespace {

constexpr double kReset_s = 1.0;  // two offsets that differ more: the clock was set, or its computer rebooted
constexpr double kBreak_s = 0.1;  // stamps that differ more from the rate: samples were lost
constexpr double kRateOff = 0.05;  // of the nominal rate; a fitted rate further off is none
constexpr int kRounds = 20;        // of the robust fit
constexpr std::size_t kMostFitted = 20000;
constexpr double kLeastScale_s = 1e-6;

struct Fit {
  double middle = 0, value = 0, slope = 0;
};

/// The points, or evenly spread ones of them where they are many.
std::vector<double> thinned(const std::vector<double>& all) {
  const std::size_t step = 1 + all.size() / kMostFitted;
  std::vector<double> some;
  for (std::size_t i = 0; i < all.size(); i += step) some.push_back(all[i]);
  return some;
}

/// Straight line through the points; with weights that leave outliers out (Huber).
Fit robustLine(const std::vector<double>& all_x, const std::vector<double>& all_y) {
  const auto x = thinned(all_x), y = thinned(all_y);
  std::vector<double> weights(x.size(), 1.0);
  Fit fit;
  for (int round = 0; round < kRounds; ++round) {
    double w = 0, wx = 0, wy = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
      w += weights[i], wx += weights[i] * x[i], wy += weights[i] * y[i];
    fit.middle = wx / w, fit.value = wy / w;
    double xx = 0, xy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      xx += weights[i] * (x[i] - fit.middle) * (x[i] - fit.middle);
      xy += weights[i] * (x[i] - fit.middle) * (y[i] - fit.value);
    }
    fit.slope = xx > 0 ? xy / xx : 0;
    std::vector<double> off;
    for (std::size_t i = 0; i < x.size(); ++i)
      off.push_back(std::abs(y[i] - fit.value - fit.slope * (x[i] - fit.middle)));
    std::vector<double> sorted = off;
    std::nth_element(sorted.begin(), sorted.begin() + std::ptrdiff_t(sorted.size() / 2), sorted.end());
    const double scale = std::max(kLeastScale_s, 1.4826 * sorted[sorted.size() / 2]);
    for (std::size_t i = 0; i < x.size(); ++i) weights[i] = off[i] <= scale ? 1.0 : scale / off[i];
  }
  return fit;
}

}  // namespace

XdfClock::XdfClock(const std::vector<XdfClockOffset>& offsets) {
  for (std::size_t begin = 0, end = 0; begin < offsets.size(); begin = end) {
    std::vector<double> at, value;
    for (end = begin; end < offsets.size(); ++end) {
      if (end > begin && (std::abs(offsets[end].value_s - offsets[end - 1].value_s) > kReset_s ||
                          offsets[end].at_s < offsets[end - 1].at_s))
        break;
      at.push_back(offsets[end].at_s);
      value.push_back(offsets[end].value_s);
    }
    Fit fit = robustLine(at, value);
    if (at.size() < 3) fit.slope = 0;
    lines_.push_back({at.front(), at.back(), fit.middle, fit.value, fit.slope});
  }
}

double XdfClock::offset_s(double stamp_s) const {
  const Line* nearest = nullptr;
  double least_s = 0;
  for (const auto& line : lines_) {
    const double away_s = std::max({0.0, line.from_s - stamp_s, stamp_s - line.to_s});
    if (nearest && away_s >= least_s) continue;
    nearest = &line;
    least_s = away_s;
  }
  return nearest ? nearest->offset_s + nearest->slope * (stamp_s - nearest->middle_s) : 0;
}

XdfTimes::XdfTimes(const XdfSeries& series, double rate_hz, const XdfClock& clock) {
  const double step_s = 1 / rate_hz;
  const auto& stamps = series.stamps;
  for (std::size_t begin = 0, end = 0; begin < stamps.size(); begin = end) {
    std::vector<double> index, time;
    for (end = begin; end < stamps.size(); ++end) {
      const double at_s = clock.recorded_s(stamps[end].stamp_s);
      if (!time.empty() && std::abs(at_s - time.back() -
                                    step_s * double(stamps[end].index - stamps[end - 1].index)) > kBreak_s)
        break;
      index.push_back(double(stamps[end].index - stamps[begin].index));
      time.push_back(at_s);
    }
    const std::uint64_t last = end < stamps.size() ? stamps[end].index : series.values.size();
    Fit fit = robustLine(index, time);
    if (!(std::abs(fit.slope / step_s - 1) < kRateOff)) fit.slope = step_s;
    pieces_.push_back({stamps[begin].index, last, fit.value - fit.slope * fit.middle, fit.slope});
  }
}

std::optional<std::pair<std::uint64_t, std::uint64_t>> XdfTimes::within(double from_s, double to_s) const {
  for (const auto& piece : pieces_) {
    const double first = std::ceil((from_s - piece.start_s) / piece.step_s);
    const double last = std::floor((to_s - piece.start_s) / piece.step_s) + 1;
    if (first < 0 || last > double(piece.last - piece.first) || last <= first) continue;
    return std::pair(piece.first + std::uint64_t(first), piece.first + std::uint64_t(last));
  }
  return std::nullopt;
}

}  // namespace facenav::steps
