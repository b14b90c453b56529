#pragma once
// PauseTimes: when a session was paused, by the steady clock, and why. Safe to use from several threads:
// sources of pulses ask whether their pulse fell into a pause.

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/timestamp.h"

namespace facenav::session {

class PauseTimes {
 public:
  /// `is_paused`: a pause of an earlier run that has not ended.
  explicit PauseTimes(bool is_paused = false);

  /// Begins a pause. Returns false if one is under way.
  bool begin(const std::string& reason, Timestamp at = Timestamp::now());
  /// Ends the pause and returns its length, s. Nothing if there is none.
  std::optional<double> end(Timestamp at = Timestamp::now());

  bool isPaused() const;
  /// Reason of the pause under way; empty without one.
  std::string reason() const;
  /// Length of the pause under way, s; 0 without one.
  double length_s() const;
  /// True if that moment lies in a pause.
  bool holds(Timestamp at) const;
  /// Time in pauses until then, s.
  double total_s(Timestamp until = Timestamp::now()) const;

 private:
  struct Pause {
    Timestamp from;
    std::optional<Timestamp> to;
  };
  bool isUnderWay() const { return !pauses_.empty() && !pauses_.back().to; }

  mutable std::mutex mutex_;
  std::vector<Pause> pauses_;
  std::string reason_;
};

}  // namespace facenav::session
