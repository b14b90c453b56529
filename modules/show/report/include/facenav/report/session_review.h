#pragma once
// Summary of a stored session, for the list of sessions and the head of the report. Every number comes from
// the session's files; what they lack is absent.

#include <optional>
#include <string>
#include <vector>

#include "facenav/casefile/kept_session.h"

namespace facenav::report {

/// Median and 95th percentile (the smallest value that 95 % do not exceed).
struct Spread {
  double median = 0, p95 = 0;
};
/// Median and 95th percentile of the values; nothing for an empty list.
std::optional<Spread> spreadOf(std::vector<double> values);

struct SessionSummary {
  std::string name, started_utc;           // 2026-11-23T14:05:09Z
  std::optional<double> duration_s;        // with pauses
  std::optional<double> paused_s, away_s;  // casefile::SessionTimes; absent in older sessions
  int pulses = 0;                          // all pulses; of these:
  int on_target = 0, outside = 0, lost = 0, excluded = 0;
  int in_pause = 0;                   // given while paused; never on target
  int double_triggers = 0;            // not counted as pulses
  std::optional<Spread> distance_mm;  // of the pulses that are not excluded and have a pose
  std::optional<Spread> tilt_deg;     // likewise
  std::optional<double> guided_s, off_target_s, lost_s;  // off target includes lost
  int face_losses = 0, coil_losses = 0, faults = 0, adverse_events = 0;
  bool has_ended = false;  // false: it still runs, or the program or the machine stopped
  std::string end;  // how, in words: "ended normally" only if a person ended it and no fault stopped it
  bool is_at_home = false;            // held by the person's own hands, at home
  int continuations = 0;              // how often it was continued after it was cut off or ended
  std::optional<double> clock_set_s;  // largest step of the time of day between two pulses, over 1 s
  // Error of the alignment at the target, as stored with the pulses, median: standard error, and the bound
  // that 95 of 100 alignments keep (absent in older sessions).
  std::optional<double> predicted_error_mm, error_bound_mm;
  std::optional<std::string> alignment;         // detail of the session's event
  std::vector<std::string> alignment_cautions;  // in words, each once
  int meps = 0;                                 // pulses that have one
  std::vector<std::string> problems;            // damaged lines, in words
};

SessionSummary summarise(const casefile::KeptSession& session);
/// Summarises the sessions, oldest first. A session that cannot be read is listed with the reason in
/// `problems`.
std::vector<SessionSummary> summariseSessions(const std::filesystem::path& case_folder);

}  // namespace facenav::report
