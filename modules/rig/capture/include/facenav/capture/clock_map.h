#pragma once
// ClockMap: maps time stamps of a camera's own clock to this computer's steady clock. A camera's clock starts
// anywhere, drifts (some 50 ppm) and may jump. The smallest delay between time stamp and arrival over the
// last two seconds is taken as constant: transport only ever adds delay. So a mapped time is late by the
// shortest transport time, equal for two equal cameras, and free of the jitter of single arrivals. If the
// smallest delay grows faster than clocks drift, the pictures come late: their mapped times stay correct.

#include <cstdint>
#include <deque>
#include <limits>
#include <optional>

namespace facenav::capture {

class ClockMap {
 public:
  /// Steady time (s) of the picture stamped `device_s`, which arrived at `arrival_s`. Strictly increasing.
  double map(double device_s, double arrival_s);
  /// Jumps of the device's clock so far.
  std::int64_t steps() const { return steps_; }
  /// Time for which all pictures have come more than half a second late, because they are read more slowly
  /// than they are sent. 0: the last one did not.
  double lateFor_s() const { return late_since_s_ ? last_.arrival_s - *late_since_s_ : 0.0; }

 private:
  struct Picture {
    double device_s = -1e300, arrival_s = -1e300;
    double delay_s() const { return arrival_s - device_s; }
  };
  void forgetAfterJump(const Picture& picture);
  void forgetOldest();
  double leastDelay_s() const;
  double shortestStep_s() const;

  std::deque<Picture> pictures_;  // pictures of the last two seconds
  Picture last_;
  double floor_s_ = std::numeric_limits<double>::infinity();  // least delay, limited by the drift of clocks
  std::optional<double> late_since_s_;
  double last_mapped_s_ = -1e300;
  std::int64_t steps_ = 0;
};

}  // namespace facenav::capture
