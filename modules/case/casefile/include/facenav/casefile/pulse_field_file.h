#pragma once
// pulse_fields.jsonl: the electric field of a session's pulses (casefile/pulse.h), computed from their poses
// during the session or later. One line a pulse; of several lines for one pulse the last one counts.

#include <filesystem>
#include <map>

#include "facenav/casefile/pulse.h"

namespace facenav::casefile {

/// Appends the fields by the numbers of their pulses, and syncs once. Throws Error.
void keepPulseFields(const std::filesystem::path& session_folder, const std::map<int, PulseField>& fields);
/// Reads them by the pulses' numbers. Damaged lines are left out.
std::map<int, PulseField> readPulseFields(const std::filesystem::path& session_folder);

}  // namespace facenav::casefile
