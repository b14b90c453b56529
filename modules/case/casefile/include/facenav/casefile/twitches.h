#pragma once
// Twitches: whether the muscle moved at a pulse, as entered by key if there is no EMG. Stored as lines of
// pulse_edits.jsonl ("change": "twitch") beside the other later entries.

#include <filesystem>
#include <map>
#include <optional>

namespace facenav::casefile {

/// Appends an answer and syncs; nothing: takes the pulse's answer back. The pulse itself may be written a
/// moment later. Throws Error.
void keepTwitch(const std::filesystem::path& session_folder, int pulse, std::optional<bool> has_twitched);
/// Reads the answers by pulse number; the last answer counts. Damaged lines are left out.
std::map<int, bool> readTwitches(const std::filesystem::path& session_folder);

}  // namespace facenav::casefile
