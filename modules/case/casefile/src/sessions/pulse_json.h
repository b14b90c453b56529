#pragma once
// One line of pulses.jsonl.

#include "facenav/casefile/pulse.h"
#include "facenav/core/json_reader.h"

namespace facenav::casefile {

/// Parses a pulse. Throws Error naming line and key.
Pulse pulseFrom(const JsonReader& line);

}  // namespace facenav::casefile
