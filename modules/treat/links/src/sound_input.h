#pragma once
// SoundInput: samples of a sound card or of a sound file, with their capture times.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "facenav/core/timestamp.h"

namespace facenav::links {

/// Computes when a sample was taken, from a driver's sample counts and their times. A driver counts up to a
/// few milliseconds late, never early. So the earliest time is used, corrected for the drift of the card's
/// clock.
class SampleClock {
 public:
  explicit SampleClock(double samples_per_s) : samples_per_s_(samples_per_s) {}
  /// Adds a reading: at `at`, the driver had counted `count` samples.
  void note(std::int64_t count, Timestamp at);
  Timestamp timeOf(std::int64_t sample) const { return {offset_s_ + double(sample) / samples_per_s_}; }
  /// Restarts the estimate after lost samples.
  void restart() { is_known_ = false; }

 private:
  double samples_per_s_, offset_s_ = 0;
  Timestamp noted_;
  bool is_known_ = false;
};

class SoundInput {
 public:
  enum class Heard { samples, nothing_yet, lost_some, end, gone };
  virtual ~SoundInput() = default;
  virtual double samplesPerSecond() const = 0;
  /// Reads samples into `samples` (one channel, -1..1), waiting at most `wait_ms`.
  virtual Heard read(std::vector<float>& samples, int wait_ms) = 0;
  /// Time at which the sample with this number, counted from the first one read, was taken.
  virtual Timestamp timeOf(std::int64_t sample) const = 0;
};

/// Opens a file of a kind that libsndfile reads; delivers it in real time from now on. Throws Error.
std::unique_ptr<SoundInput> openSoundFile(const std::string& path);
/// Opens a capture device by ALSA's name. Throws Error: not found, in use, not allowed.
std::unique_ptr<SoundInput> openSoundDevice(const std::string& name);

}  // namespace facenav::links
