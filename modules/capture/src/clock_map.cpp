#include "facenav/capture/clock_map.h"

#include <algorithm>
#include <cmath>

namespace facenav::capture {
namespace {

constexpr double kWindow_s = 2.0;  // 50 ppm of drift are 0.1 ms in it
// A smaller change of the least delay is a change of the transport, not a jump of the clock.
constexpr double kJump_s = 0.05;
constexpr double kTick_s = 1e-6;

double leastDelay_s(const std::deque<std::pair<double, double>>& delays_s) {
  double least_s = delays_s.front().second;
  for (const auto& [arrival_s, delay_s] : delays_s) least_s = std::min(least_s, delay_s);
  return least_s;
}

}  // namespace

/// A clock that jumps back shows at once. One that jumps ahead brings the least delay down by the jump.
void ClockMap::forgetAfterJump(double device_s, double arrival_s) {
  if (delays_s_.empty()) return;
  const bool is_back = device_s <= last_device_s_;
  const bool is_ahead = arrival_s - device_s < leastDelay_s(delays_s_) - kJump_s;
  if (!is_back && !is_ahead) return;
  delays_s_.clear();
  ++steps_;
}

double ClockMap::map(double device_s, double arrival_s) {
  forgetAfterJump(device_s, arrival_s);
  delays_s_.emplace_back(arrival_s, arrival_s - device_s);
  const double before_s = leastDelay_s(delays_s_);
  while (delays_s_.front().first < arrival_s - kWindow_s) delays_s_.pop_front();
  const double delay_s = leastDelay_s(delays_s_);
  if (delay_s > before_s + kJump_s) ++steps_;  // a jump back by less than a picture's interval
  last_device_s_ = device_s;
  last_mapped_s_ = std::max(device_s + delay_s, last_mapped_s_ + kTick_s);
  return last_mapped_s_;
}

}  // namespace facenav::capture
