#pragma once
// PulseTrigger: one pulse of the stimulator as it arrives from a key, a pedal, a line or a network.

#include <chrono>
#include <optional>
#include <string>

#include "facenav/core/timestamp.h"

namespace facenav::links {

struct PulseTrigger {
  std::string source = "keyboard";
  Timestamp at = Timestamp::now();  // steady clock
  std::chrono::system_clock::time_point utc = std::chrono::system_clock::now();
  /// Time within which a second trigger of the same source is a bounce, not a pulse. It must be shorter than
  /// the time between the pulses of a train.
  double dead_time_s = 0.15;
  std::optional<double> intensity_pct = {};  // % of the maximal output, if the source sends it
  bool is_in_pause = false;                  // set by the session's log
  std::string coil = {};                     // name of the coil that gave it; empty: the session's only one
};

}  // namespace facenav::links
