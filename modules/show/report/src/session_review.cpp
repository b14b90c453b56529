#include "facenav/report/session_review.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/core/utc_time.h"
#include "facenav/core/without_folders.h"
#include "facenav/report/session_notes.h"

namespace facenav::report {
namespace {

constexpr double kClockStep_s = 1.0;

/// Converts "20261123T140509Z", also with "_2", to 2026-11-23T14:05:09Z. Other names do not change.
std::string startOf(const std::string& name) {
  const std::string time = name.substr(0, 16);
  if (!secondsOfUtc(time)) return name;
  const auto part = [&](int at, int size) { return time.substr(std::size_t(at), std::size_t(size)); };
  return part(0, 4) + "-" + part(4, 2) + "-" + part(6, 2) + "T" + part(9, 2) + ":" + part(11, 2) + ":" +
         part(13, 2) + "Z";
}

void countPulses(const casefile::SessionPulses& session, SessionSummary& summary) {
  std::vector<double> distance_mm, tilt_deg, error_mm, bound_mm;
  for (const auto& [pulse, is_excluded, note] : session.pulses) {
    ++summary.pulses;
    if (is_excluded) {
      ++summary.excluded;
      continue;
    }
    summary.on_target += pulse.status == casefile::PulseStatus::on_target;
    summary.outside += pulse.status == casefile::PulseStatus::outside;
    summary.lost += pulse.status == casefile::PulseStatus::lost;
    summary.in_pause += pulse.is_in_pause;
    summary.meps += pulse.mep_uv.has_value();
    if (pulse.predicted_error_mm) error_mm.push_back(*pulse.predicted_error_mm);
    if (pulse.error_bound_mm) bound_mm.push_back(*pulse.error_bound_mm);
    if (!pulse.offset) continue;
    distance_mm.push_back(pulse.offset->distance_mm);
    tilt_deg.push_back(pulse.offset->tilt_deg);
  }
  summary.distance_mm = spreadOf(std::move(distance_mm));
  summary.tilt_deg = spreadOf(std::move(tilt_deg));
  if (!error_mm.empty()) summary.predicted_error_mm = median(error_mm);
  if (!bound_mm.empty()) summary.error_bound_mm = median(bound_mm);
}

/// Largest step of the time of day against the monotonic clock, which nobody can set.
std::optional<double> clockStep_s(const casefile::SessionPulses& session) {
  std::optional<double> before_s;
  double largest_s = 0;
  for (const auto& reviewed : session.pulses) {
    const auto utc_s = secondsOfUtc(reviewed.pulse.utc);
    if (!utc_s || reviewed.pulse.steady_s == 0) continue;
    const double ahead_s = *utc_s - reviewed.pulse.steady_s;
    if (before_s && std::abs(ahead_s - *before_s) > std::abs(largest_s)) largest_s = ahead_s - *before_s;
    before_s = ahead_s;
  }
  if (std::abs(largest_s) < kClockStep_s) return std::nullopt;
  return largest_s;
}

/// Describes the end. A session that a fault stopped, or that ended with its window, has not ended normally.
void describeEnd(const std::vector<casefile::SessionEvent>& events, SessionSummary& summary) {
  std::string fault, why;  // fault: the last one from which the session did not recover
  for (const auto& e : events) {
    if (e.event == "fault") fault = withoutFolders(e.detail);
    if (e.event == "face found" || e.event == "cameras back" || e.event == "session continued") fault.clear();
    if (e.event != "session ended" && e.event != "session continued") continue;  // the last one counts
    summary.has_ended = e.event == "session ended";
    why = e.detail;
  }
  summary.end = !summary.has_ended ? "not ended: it still runs, or it was cut off"
                : !fault.empty()   ? "stopped by a fault: " + fault
                : !why.empty()     ? "ended, but not by the operator: " + why
                                   : "ended normally";
}

void countEvents(const std::vector<casefile::SessionEvent>& events, SessionSummary& summary) {
  const auto count = [&](const char* name) {
    return int(std::count_if(events.begin(), events.end(), [&](const auto& e) { return e.event == name; }));
  };
  summary.face_losses = count("face lost");
  summary.coil_losses = count("coil lost");
  summary.faults = count("fault");
  summary.adverse_events = count("adverse event");
  summary.double_triggers = count("double trigger");
  summary.continuations = count("session continued");
  summary.is_at_home |= count("at home") > 0;
  for (const auto& e : events) {
    if (e.event == "alignment") summary.alignment = e.detail;
    auto& cautions = summary.alignment_cautions;
    if (e.event == session_events::kAlignmentCaution &&
        std::find(cautions.begin(), cautions.end(), e.detail) == cautions.end())
      cautions.push_back(e.detail);
  }
  describeEnd(events, summary);
}

}  // namespace

std::optional<Spread> spreadOf(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  const auto rank = std::size_t(std::ceil(0.95 * double(values.size()))) - 1;
  return Spread{median(values), valueAtRank(values, rank)};
}

SessionSummary summarise(const casefile::KeptSession& session) {
  SessionSummary summary;
  summary.name = session.name;
  summary.started_utc = startOf(session.name);
  summary.duration_s = session.duration_s;
  summary.paused_s = session.paused_s;
  summary.away_s = session.away_s;
  summary.is_at_home = session.returned_utc.has_value();
  countPulses(session.pulses, summary);
  countEvents(session.events, summary);
  if (session.guided) {
    summary.guided_s = session.guided->total_s();
    summary.off_target_s = session.guided->adjust_s + session.guided->lost_s;
    summary.lost_s = session.guided->lost_s;
  }
  summary.clock_set_s = clockStep_s(session.pulses);
  summary.problems = session.pulses.problems;
  return summary;
}

std::vector<SessionSummary> summariseSessions(const std::filesystem::path& case_folder) {
  std::vector<SessionSummary> summaries;
  for (const auto& folder : casefile::sessionFolders(case_folder)) {
    try {
      summaries.push_back(summarise(casefile::readSession(folder)));
    } catch (const Error& error) {
      SessionSummary unread;
      unread.name = folder.filename().string();
      unread.started_utc = startOf(unread.name);
      unread.problems = {error.what()};
      summaries.push_back(std::move(unread));
    }
  }
  return summaries;
}

}  // namespace facenav::report
