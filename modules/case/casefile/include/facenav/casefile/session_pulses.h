#pragma once
// The pulses of a kept session, with what was changed afterwards, and pulses.csv (resources/doc/formats.md).
// A pulse can be excluded with a reason and taken in again, and its MEP can be entered; nothing removes it.
// Changes are appended to pulse_edits.jsonl beside pulses.jsonl, so that the whole history stays.

#include <filesystem>
#include <optional>
#include <set>
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
  std::set<int> edited_meps;          // numbers of the pulses whose MEP was entered after the pulse
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
/// The same for several, all of them or none.
void editPulses(const std::filesystem::path& session_folder, const std::vector<PulseEdit>& edits);

constexpr double kLargestMep_uv = 50000;  // compound action potentials of a hand muscle reach some 20 mV

/// Entered after the pulse; absent: not known (which takes back an earlier entry).
struct MepEdit {
  int number = 0;
  std::optional<double> mep_uv, latency_ms;
  std::string reason, by;  // reason: where the value comes from ("typed", "file.csv"); both may be empty
};
/// All of them or none; appends and syncs once. Throws Error: no such pulse, or a value that is no MEP
/// (0..kLargestMep_uv) or no latency (0..1000 ms).
void editMeps(const std::filesystem::path& session_folder, const std::vector<MepEdit>& edits);

/// The whole of pulses.csv; an empty field is not known, `excluded` is 1 or 0.
std::string pulsesCsv(const std::vector<ReviewedPulse>& pulses);

}  // namespace facenav::casefile
