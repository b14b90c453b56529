#pragma once
// The outline of one session for a support bundle: counts of poses and pulses, and its events with the time
// since its start.

#include <filesystem>
#include <nlohmann/json.hpp>

#include "support/scrubbed_words.h"

namespace facenav::app {

/// Details stay only of events that the program words itself, and scrubbed. A fault in a file is told in its
/// place.
nlohmann::ordered_json sessionOutline(const std::filesystem::path& session_folder, const Scrubber& scrubber);

}  // namespace facenav::app
