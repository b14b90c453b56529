#pragma once
// The pulses of a kept session, with their exclusions, and pulses.csv (FORMATS.md). A pulse can be excluded
// with a reason and taken in again; nothing removes it. Exclusions are appended to pulse_edits.jsonl beside
// pulses.jsonl, so that the whole history stays.

#include <filesystem>
#include <string>
#include <vector>

#include "facenav/casefile/pulse.h"

namespace facenav::casefile {

struct ReviewedPulse {
  Pulse pulse;
  bool is_excluded = false;
  std::string note;  // the reason of the exclusion
};

struct SessionPulses {
  std::vector<ReviewedPulse> pulses;
  std::vector<std::string> problems;  // lines that could not be read, in words: they are left out
};

/// Reads pulses.jsonl and pulse_edits.jsonl. A torn or damaged line is left out and named in `problems`; a
/// number that stands there twice counts once. A session without the file (older versions) gives the pulses
/// that its events.jsonl notes, without poses. Throws Error where a file cannot be read at all.
SessionPulses readSessionPulses(const std::filesystem::path& session_folder);

struct PulseEdit {
  int number = 0;
  bool is_excluded = true;
  std::string reason, by;  // by: staff, may be empty
};
/// Appends and syncs. Throws Error: no such pulse, an exclusion without a reason, or already so.
void editPulse(const std::filesystem::path& session_folder, const PulseEdit& edit);

/// The whole of pulses.csv; an empty field is not known, `excluded` is 1 or 0.
std::string pulsesCsv(const std::vector<ReviewedPulse>& pulses);

}  // namespace facenav::casefile
