#include "click_detector.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace facenav::links {
namespace {

constexpr double kStepsPerMs = 8;
constexpr double kSettles_ms = 100;  // settling time of filters and floor
constexpr std::size_t kOthers = 5;
constexpr double kFloorStep = 1.0005;  // so the floor follows the median within about half a second

}  // namespace

double ClickDetector::HighPass::next(double x) {
  const double y = b0 * x + z1;
  z1 = b1 * x - a1 * y + z2;
  z2 = b2 * x - a2 * y;
  return y;
}

ClickDetector::ClickDetector(double samples_per_s, double dead_s, const ClickRules& rules)
    : samples_per_s_(samples_per_s),
      rules_(rules),
      samples_per_step_(std::max(1, int(std::lround(samples_per_s / (1000 * kStepsPerMs))))),
      dead_steps_(stepsOf(dead_s * 1000)),
      lookahead_(stepsOf(rules.click_lull_after_ms)),
      history_(stepsOf(rules.click_lull_before_ms)),
      settled_(stepsOf(kSettles_ms)) {
  // Butterworth by the bilinear transform (RBJ's cookbook, Q = 1/sqrt 2).
  const double hz = std::min(rules.click_high_pass_hz, 0.4 * samples_per_s);
  const double w = 2 * M_PI * hz / samples_per_s, alpha = std::sin(w) / std::sqrt(2.0), a0 = 1 + alpha;
  HighPass filter;
  filter.b0 = filter.b2 = (1 + std::cos(w)) / 2 / a0;
  filter.b1 = -(1 + std::cos(w)) / a0;
  filter.a1 = -2 * std::cos(w) / a0;
  filter.a2 = (1 - alpha) / a0;
  filters_.fill(filter);
}

std::int64_t ClickDetector::stepsOf(double ms) const {
  return std::int64_t(std::lround(ms * samples_per_s_ / 1000 / samples_per_step_));
}

/// Largest power of the known steps from `first` to `last`.
double ClickDetector::most(std::int64_t first, std::int64_t last, bool with_clicks) const {
  double power = 0;
  const std::int64_t end = std::min(last, first_step_ + std::int64_t(steps_.size()) - 1);
  for (std::int64_t i = std::max(first, first_step_); i <= end; ++i) {
    const Step& step = steps_[std::size_t(i - first_step_)];
    if (with_clicks || !step.is_click) power = std::max(power, step.power);
  }
  return power;
}

bool ClickDetector::isClickAt(std::int64_t step) const {
  const std::int64_t longest = stepsOf(rules_.click_longest_ms);
  const double before = std::max(most(step - history_, step - 1, false), floor_);
  if (steps_[std::size_t(step - first_step_)].power < rules_.click_rise * before) return false;
  const double peak = most(step, step + longest, true);
  const double least = rules_.click_least_peak * rules_.click_least_peak / 2;
  if (peak < rules_.click_over_floor * floor_ || peak < least) return false;
  if (peak < rules_.click_over_others * usualPeak()) return false;
  const bool may_be_echo = last_ >= 0 && step - last_ < stepsOf(rules_.click_echo_ms);
  if (may_be_echo && peak < rules_.click_over_echo * last_peak_) return false;
  return most(step + longest + 1, step + lookahead_, true) <= rules_.click_still_after * peak;
}

/// Median peak of the last clicks; 0 while there are too few. A single bang does not change it.
double ClickDetector::usualPeak() const {
  if (peaks_.size() < kOthers) return 0;
  std::vector<double> sorted(peaks_.begin(), peaks_.end());
  std::nth_element(sorted.begin(), sorted.begin() + kOthers / 2, sorted.end());
  return sorted[kOthers / 2];
}

/// First step of the click. The search may have begun shortly before it, at a sound of a voice.
std::int64_t ClickDetector::beginOf(std::int64_t step, double peak) const {
  constexpr double kBegins = 0.25;  // an echo of the previous click has at most an eighth
  while (steps_[std::size_t(step - first_step_)].power < kBegins * peak) ++step;
  return step;
}

void ClickDetector::endStep() {
  const double power = sum_ / samples_per_step_;
  sum_ = 0, in_step_ = 0;
  if (floor_ < 0) floor_ = power;
  floor_ = std::max(1e-12, power > floor_ ? floor_ * kFloorStep : floor_ / kFloorStep);
  steps_.push_back({power, false});
  const std::int64_t at = first_step_ + std::int64_t(steps_.size()) - 1 - lookahead_;
  if (at > settled_ && at >= dead_until_ && isClickAt(at)) {
    last_peak_ = most(at, at + stepsOf(rules_.click_longest_ms), true);
    last_ = beginOf(at, last_peak_);
    found_.push_back(last_ * samples_per_step_);
    dead_until_ = last_ + dead_steps_;
    peaks_.push_back(last_peak_);
    if (peaks_.size() > kOthers) peaks_.pop_front();
    for (std::int64_t i = at; i < std::min(dead_until_, first_step_ + std::int64_t(steps_.size())); ++i)
      steps_[std::size_t(i - first_step_)].is_click = true;
  }
  steps_.back().is_click |= first_step_ + std::int64_t(steps_.size()) - 1 < dead_until_;
  while (std::int64_t(steps_.size()) > history_ + lookahead_ + 2) {
    steps_.pop_front();
    ++first_step_;
  }
}

std::vector<std::int64_t> ClickDetector::hear(const float* samples, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const double high = filters_[1].next(filters_[0].next(samples[i]));
    sum_ += high * high;
    if (++in_step_ == samples_per_step_) endStep();
  }
  return std::exchange(found_, {});
}

}  // namespace facenav::links
