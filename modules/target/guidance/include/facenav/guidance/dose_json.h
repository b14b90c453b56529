#pragma once
// A dose in JSON: members pulses, trains, frequency_hz, pause_s, output_pct, threshold_pct of an object.

#include <string>
#include <utility>
#include <vector>

#include "facenav/core/json_reader.h"
#include "facenav/guidance/dose.h"

namespace facenav::guidance {

/// Reads a dose. Throws Error naming file and key if pulses is missing, or a number is malformed or out of
/// range.
Dose readDose(const JsonReader& json);
/// Returns the members to write, in their order; absent values are left out.
std::vector<std::pair<std::string, double>> doseNumbers(const Dose& dose);

}  // namespace facenav::guidance
