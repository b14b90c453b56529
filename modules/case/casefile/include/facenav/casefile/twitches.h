#pragma once
// Twitches: whether the muscle moved at a pulse, as a person answered by key where no EMG was there. Kept as
// lines of pulse_edits.jsonl ("change": "twitch") beside the other things entered after a pulse.

#include <filesystem>
#include <map>

namespace facenav::casefile {

/// Appends and syncs. The pulse itself may be written a moment later. Throws Error.
void keepTwitch(const std::filesystem::path& session_folder, int pulse, bool has_twitched);
/// By the pulse's number; the last answer counts. Damaged lines are passed over.
std::map<int, bool> readTwitches(const std::filesystem::path& session_folder);

}  // namespace facenav::casefile
