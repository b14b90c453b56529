#pragma once
// A dose in JSON: members pulses, trains, frequency_hz, pause_s, output_pct, threshold_pct of an object.

#include <string>
#include <utility>
#include <vector>

#include "facenav/core/json_reader.h"
#include "facenav/guidance/dose.h"

namespace facenav::guidance {

/// Throws Error naming file and key: no pulses, a malformed number, or one out of range.
Dose readDose(const JsonReader& json);
/// The members to write, in their order; what is not stated is left out.
std::vector<std::pair<std::string, double>> doseNumbers(const Dose& dose);

}  // namespace facenav::guidance
