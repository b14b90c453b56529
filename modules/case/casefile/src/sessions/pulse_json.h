#pragma once
// One line of pulses.jsonl, and a target in a line.

#include <nlohmann/json.hpp>

#include "facenav/casefile/pulse.h"
#include "facenav/core/json_reader.h"

namespace facenav::casefile {

/// Parses a pulse. Throws Error naming line and key.
Pulse pulseFrom(const JsonReader& line);

/// A target with name, pose and places.
nlohmann::ordered_json targetJson(const guidance::Target& target);
/// Throws Error naming line and key.
guidance::Target targetFrom(const JsonReader& json);

}  // namespace facenav::casefile
