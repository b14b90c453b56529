#pragma once
// ClockMap: time stamps of a camera's own clock -> this computer's steady clock. A camera's clock starts
// anywhere, drifts (some 50 ppm) and may jump. The smallest delay between time stamp and arrival over the
// last two seconds is taken as constant: transport only ever adds delay. So a mapped time is late by the
// shortest transport time, equal for two equal cameras, and free of the jitter of single arrivals.

#include <cstdint>
#include <deque>
#include <utility>

namespace facenav::capture {

class ClockMap {
 public:
  /// Steady time (s) of the picture stamped `device_s`, which arrived at `arrival_s`. Strictly increasing.
  double map(double device_s, double arrival_s);
  /// Jumps of the device's clock so far.
  std::int64_t steps() const { return steps_; }

 private:
  void forgetAfterJump(double device_s, double arrival_s);
  std::deque<std::pair<double, double>> delays_s_;  // arrival, arrival - device
  double last_device_s_ = -1e300, last_mapped_s_ = -1e300;
  std::int64_t steps_ = 0;
};

}  // namespace facenav::capture
