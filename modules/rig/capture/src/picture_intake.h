#pragma once
// PictureIntake: the common processing of an arrived picture in every backend: a time stamp on the steady
// clock, gaps in the driver's numbers, pictures that came twice, counts.

#include <opencv2/core.hpp>

#include "facenav/capture/camera.h"
#include "facenav/capture/clock_map.h"

namespace facenav::capture {

enum class StampClock {
  steady,  // the driver stamps with this computer's steady clock
  device,  // the driver stamps with a clock of its own
  none,    // no stamps: the arrival counts
  file,    // the stamps of a file; its pictures all count, equal ones too
};

class PictureIntake {
 public:
  void restart() { *this = {}; }
  void noteDamaged() { ++counts_.damaged; }
  void noteDropped(std::int64_t pictures) { counts_.dropped += pictures; }
  /// Accepts a picture and adds its time; nullopt if it repeats the previous one (live pictures only).
  /// `stamp_s`: as the driver gives it.
  std::optional<CameraPicture> accept(cv::Mat grey, std::int64_t sequence, StampClock clock, double stamp_s,
                                      double arrival_s);
  const PictureCounts& counts() const { return counts_; }
  /// Lateness as ClockMap::lateFor_s(); 0 without stamps of the device's clock.
  double lateFor_s() const { return clock_.lateFor_s(); }

 private:
  double steadyTime(StampClock clock, double stamp_s, double arrival_s);
  std::int64_t number(std::int64_t sequence);

  PictureCounts counts_;
  ClockMap clock_;
  cv::Mat last_;
  double last_s_ = -1e300;
  double last_age_s_ = 0.0;
  std::optional<std::int64_t> last_sequence_;
  std::int64_t number_ = -1;
};

}  // namespace facenav::capture
