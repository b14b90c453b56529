#pragma once
// SoundInput: samples of a sound card or of a sound file, with the time at which each was taken.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "facenav/core/timestamp.h"

namespace facenav::links {

/// Tells when a sample was taken, from the times at which a driver says how many there are. A driver counts
/// late, never early, by up to a few milliseconds: the earliest time counts, and follows the card's own
/// clock.
class SampleClock {
 public:
  explicit SampleClock(double samples_per_s) : samples_per_s_(samples_per_s) {}
  /// By `at`, `count` samples since the beginning were there.
  void note(std::int64_t count, Timestamp at);
  Timestamp timeOf(std::int64_t sample) const { return {offset_s_ + double(sample) / samples_per_s_}; }
  /// After samples were lost.
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
  /// Waits at most `wait_ms`. `samples`: one channel, -1..1; of `samples` only.
  virtual Heard read(std::vector<float>& samples, int wait_ms) = 0;
  /// When the sample of that number, counted from the first one read, was taken.
  virtual Timestamp timeOf(std::int64_t sample) const = 0;
};

/// A file of libsndfile's kinds, delivered at its own speed from now on. Throws Error.
std::unique_ptr<SoundInput> openSoundFile(const std::string& path);
/// A capture device by ALSA's name. Throws Error: not there, in use, not allowed.
std::unique_ptr<SoundInput> openSoundDevice(const std::string& name);

}  // namespace facenav::links
