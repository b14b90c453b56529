#include "facenav/capture/clock_map.h"

#include <algorithm>
#include <cmath>

namespace facenav::capture {
namespace {

constexpr double kWindow_s = 2.0;  // 50 ppm of drift are 0.1 ms in this window
// A smaller change of the least delay is a change of the transport, not a jump of the clock.
constexpr double kJump_s = 0.05;
constexpr double kTick_s = 1e-6;
constexpr double kMostDrift = 200e-6;       // largest drift of two clocks against each other
constexpr double kTransportGrows_s = 0.02;  // by a busier line; a larger growth is a late picture
constexpr double kLate_s = 0.5;

}  // namespace

double ClockMap::leastDelay_s() const {
  double least_s = pictures_.front().delay_s();
  for (const auto& picture : pictures_) least_s = std::min(least_s, picture.delay_s());
  return least_s;
}

/// Shortest time between two pictures, by the device's clock; 0 if there are fewer than two.
double ClockMap::shortestStep_s() const {
  if (pictures_.size() < 2) return 0.0;
  double shortest_s = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < pictures_.size(); ++i)
    shortest_s = std::min(shortest_s, pictures_[i].device_s - pictures_[i - 1].device_s);
  return shortest_s;
}

/// Detects jumps of the clock. A jump back is visible at once. A jump ahead reduces the least delay by the
/// jump. Late pictures that catch up are no jump: the delay stays above its former least value.
void ClockMap::forgetAfterJump(const Picture& picture) {
  if (pictures_.empty()) return;
  const bool is_back = picture.device_s <= last_.device_s;
  const bool is_ahead = picture.delay_s() < floor_s_ - kJump_s;
  if (!is_back && !is_ahead) return;
  pictures_.clear();
  floor_s_ = std::numeric_limits<double>::infinity();
  ++steps_;
}

/// Detects a jump back by less than a picture's interval: one short step of the device's clock, after which
/// all delays are longer by the missing part of the step. Late pictures have no such step.
void ClockMap::forgetOldest() {
  const double step_s = pictures_[1].device_s - pictures_[0].device_s;
  pictures_.pop_front();
  const double jump_s = shortestStep_s() - step_s, rise_s = leastDelay_s() - floor_s_;
  if (std::min(jump_s, rise_s) < kTransportGrows_s || std::abs(rise_s - jump_s) > kTransportGrows_s) return;
  floor_s_ += rise_s;
  ++steps_;
}

double ClockMap::map(double device_s, double arrival_s) {
  const Picture picture{device_s, arrival_s};
  forgetAfterJump(picture);
  if (!pictures_.empty()) floor_s_ += kMostDrift * (arrival_s - last_.arrival_s);
  pictures_.push_back(picture);
  last_ = picture;
  while (pictures_.front().arrival_s < arrival_s - kWindow_s) forgetOldest();
  const double least_s = leastDelay_s();
  floor_s_ = std::min(floor_s_, least_s);
  if (picture.delay_s() - floor_s_ < kLate_s)
    late_since_s_.reset();
  else if (!late_since_s_)
    late_since_s_ = arrival_s;
  const double delay_s = std::min(least_s, floor_s_ + kTransportGrows_s);
  last_mapped_s_ = std::max(device_s + delay_s, last_mapped_s_ + kTick_s);
  return last_mapped_s_;
}

}  // namespace facenav::capture
