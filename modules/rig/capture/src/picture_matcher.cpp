#include "facenav/capture/picture_matcher.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace facenav::capture {
namespace {

constexpr std::size_t kLongestQueue = 8, kIntervals = 31, kDelays = 121;
constexpr double kFollow = 0.1;         // weight of a new delay in the running mean
constexpr double kSwitchPartner = 0.6;  // share of an interval
constexpr double kTies_s = 1e-9;

double middleOf(const std::deque<double>& values) {
  std::vector<double> sorted(values.begin(), values.end());
  std::nth_element(sorted.begin(), sorted.begin() + std::ptrdiff_t(sorted.size() / 2), sorted.end());
  return sorted[sorted.size() / 2];
}

void keepNewest(std::deque<double>& values, double value, std::size_t count) {
  values.push_back(value);
  if (values.size() > count) values.pop_front();
}

}  // namespace

PictureMatcher::PictureMatcher(double interval_s) : expected_interval_s_(interval_s) {}

void PictureMatcher::Side::add(CameraPicture picture) {
  if (last_s > -1e299) keepNewest(intervals_s, picture.captured.s - last_s, kIntervals);
  last_s = picture.captured.s;
  waiting.push_back(std::move(picture));
  if (waiting.size() > kLongestQueue) dropFront();
}

void PictureMatcher::Side::dropFront() {
  waiting.pop_front();
  ++alone;
}

std::optional<double> PictureMatcher::Side::interval_s() const {
  return intervals_s.size() < 5 ? std::nullopt : std::optional(middleOf(intervals_s));
}

void PictureMatcher::addLeft(CameraPicture picture) { left_.add(std::move(picture)); }
void PictureMatcher::addRight(CameraPicture picture) { right_.add(std::move(picture)); }

/// Interval of the faster camera: its pictures decide how near a partner can be.
double PictureMatcher::interval_s() const {
  const auto left_s = left_.interval_s(), right_s = right_.interval_s();
  if (!left_s || !right_s) return expected_interval_s_;
  return std::min(*left_s, *right_s);
}

void PictureMatcher::follow(double delay_s) {
  delay_s_ = has_delay_ ? delay_s_ + kFollow * (delay_s - delay_s_) : delay_s;
  has_delay_ = true;
  keepNewest(delays_s_, delay_s, kDelays);
  const double limit_s = kSwitchPartner * interval_s();
  if (std::abs(delay_s_) <= limit_s) return;
  delay_s_ -= std::copysign(interval_s(), delay_s_);
  delays_s_.clear();
}

std::optional<PicturePair> PictureMatcher::take() {
  auto &left = left_.waiting, &right = right_.waiting;
  while (!left.empty() && !right.empty()) {
    const double half_s = 0.5 * interval_s();
    const auto error_s = [&](std::size_t l, std::size_t r) {
      return right[r].captured - left[l].captured - delay_s_;
    };
    const double now_s = error_s(0, 0);
    const bool is_next_right_nearer = right.size() > 1 && std::abs(error_s(0, 1)) < std::abs(now_s);
    const bool is_next_left_nearer = left.size() > 1 && std::abs(error_s(1, 0)) < std::abs(now_s);
    if (now_s < -half_s - kTies_s || is_next_right_nearer) {
      right_.dropFront();
    } else if (now_s > half_s + kTies_s || is_next_left_nearer) {
      left_.dropFront();
    } else {
      PicturePair pair{std::move(left.front()), std::move(right.front())};
      left.pop_front();
      right.pop_front();
      ++pairs_;
      follow(pair.right_late_s());
      return pair;
    }
  }
  return std::nullopt;
}

PairTiming PictureMatcher::timing() const {
  PairTiming timing;
  timing.pairs = pairs_;
  timing.left_alone = left_.alone;
  timing.right_alone = right_.alone;
  if (delays_s_.empty()) return timing;
  timing.right_late_s = middleOf(delays_s_);
  std::deque<double> deviations_s;
  for (double delay_s : delays_s_) deviations_s.push_back(std::abs(delay_s - timing.right_late_s));
  timing.spread_s = middleOf(deviations_s);
  return timing;
}

}  // namespace facenav::capture
