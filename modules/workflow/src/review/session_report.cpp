#include "facenav/workflow/session_report.h"

#include <algorithm>
#include <cmath>

#include "facenav/casefile/sign_off.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/whole_file.h"
#include "facenav/geometry/rotation.h"
#include "facenav/guidance/guidance.h"
#include "facenav/workflow/session_review.h"
#include "facenav/workflow/software_version.h"
#include "report_html.h"
#include "report_svg.h"
#include "report_targets.h"

namespace facenav::workflow {
namespace {

constexpr const char* kNotRecorded = "not recorded";
constexpr std::size_t kMostRows = 60;  // of a table on paper; pulses.csv and events.jsonl hold all
constexpr double kNear_mm = 2.0, kNear_deg = 3.0;  // the share of pulses that published sheets state
constexpr double kDistanceBin_mm = 0.5, kTiltBin_deg = 1.0;

/// Words with a path: without its folders, whose names may be the patient's.
std::string withoutFolders(std::string words) {
  const std::size_t last = words.rfind('/');
  if (last == std::string::npos) return words;
  const std::size_t blank = words.rfind(' ', words.find('/'));
  const std::size_t first = blank == std::string::npos ? 0 : blank + 1;
  return words.erase(first, last - first + 1);
}

std::string timeWords(const std::optional<double>& seconds) {
  if (!seconds) return kNotRecorded;
  const long whole = std::lround(*seconds);
  return formatted("%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string shareWords(double part, double whole) {
  return whole > 0 ? formatted(" (%.0f %%)", 100.0 * part / whole) : std::string();
}

std::string spreadWords(const std::optional<Spread>& spread, const char* unit) {
  return spread ? formatted("%.1f / %.1f %s", spread->median, spread->p95, unit)
                : std::string("no pulse has a pose");
}

/// The details of all events of that name, the last one last.
std::string detailsOf(const casefile::KeptSession& session, const std::string& event) {
  std::string words;
  for (const auto& e : session.events)
    if (e.event == event) words += (words.empty() ? "" : "; ") + e.detail;
  return words.empty() ? kNotRecorded : words;
}

std::string nearWords(const casefile::KeptSession& session) {
  int near = 0, all = 0;
  for (const auto& [pulse, is_excluded, note] : session.pulses.pulses) {
    if (is_excluded) continue;
    ++all;
    near += pulse.offset && pulse.offset->distance_mm <= kNear_mm && pulse.offset->tilt_deg <= kNear_deg;
  }
  return formatted("%d of %d", near, all) + shareWords(near, all);
}

std::string intensityWords(const casefile::KeptSession& session) {
  std::vector<double> pct;
  for (const auto& reviewed : session.pulses.pulses)
    if (reviewed.pulse.intensity_pct) pct.push_back(*reviewed.pulse.intensity_pct);
  if (pct.empty()) return kNotRecorded;
  const auto [low, high] = std::minmax_element(pct.begin(), pct.end());
  return formatted("%g to %g %% of maximal output, stated for %zu pulses", *low, *high, pct.size());
}

std::string errorWords(const casefile::KeptSession& session) {
  std::vector<double> error_mm;
  for (const auto& reviewed : session.pulses.pulses)
    if (reviewed.pulse.predicted_error_mm) error_mm.push_back(*reviewed.pulse.predicted_error_mm);
  if (error_mm.empty()) return kNotRecorded;
  const auto [low, high] = std::minmax_element(error_mm.begin(), error_mm.end());
  return *high - *low < 0.05 ? formatted("%.1f mm (standard error of the alignment)", *high)
                             : formatted("%.1f to %.1f mm (standard error of the alignment)", *low, *high);
}

std::string signOffWords(const casefile::CaseStore& store) {
  try {
    const auto status = casefile::signOffStatus(store);
    if (!status.last) return "not signed off";
    return status.last->by + ", " + status.last->utc + (status.holds() ? "" : " (no longer valid)");
  } catch (const Error&) {
    return "cannot be read";
  }
}

std::string sessionPart(const casefile::CaseStore& store, const casefile::KeptSession& session,
                        const SessionSummary& summary) {
  return headingHtml("Session") +
         factsHtml(
             {{"Start (UTC)", summary.started_utc},
              {"Duration", timeWords(summary.duration_s)},
              {"End", summary.has_ended ? "ended normally" : "not ended: it still runs, or it was cut off"},
              {"Operator", kNotRecorded},
              {"Head model checked by", signOffWords(store)},
              {"Treated without a sign-off",
               detailsOf(session, "override") == kNotRecorded ? "no" : detailsOf(session, "override")},
              {"Pain before / after (0 to 10)", kNotRecorded},
              {"Adverse events", detailsOf(session, "adverse event")}});
}

std::string stimulationPart(const casefile::KeptSession& session, const SessionSummary& s) {
  const int counted = s.pulses - s.excluded;
  return headingHtml("Stimulation") +
         factsHtml({{"Stimulator (make, model)", kNotRecorded},
                    {"Coil", detailsOf(session, "coil")},
                    {"Muscles", kNotRecorded},
                    {"Motor threshold (method, criterion, hits of all)", kNotRecorded},
                    {"Intensity", intensityWords(session)},
                    {"Intensity in % of the motor threshold", kNotRecorded},
                    {"Trains (frequency, pulses, pauses)", kNotRecorded},
                    {"Pulses", formatted("%d", s.pulses)},
                    {"of these on target", formatted("%d", s.on_target) + shareWords(s.on_target, counted)},
                    {"outside the tolerance", formatted("%d", s.outside) + shareWords(s.outside, counted)},
                    {"with head or coil lost", formatted("%d", s.lost) + shareWords(s.lost, counted)},
                    {"excluded, with a reason", formatted("%d", s.excluded)},
                    {"Double triggers, not counted", formatted("%d", s.double_triggers)}});
}

std::string accuracyPart(const casefile::KeptSession& session, const SessionSummary& s) {
  std::vector<TableRow> rows{
      {"Alignment of MRI and head", detailsOf(session, "alignment")},
      {"Predicted error at the target", errorWords(session)},
      {"Distance of coil and target at the pulses, median / 95th percentile",
       spreadWords(s.distance_mm, "mm")},
      {"Tilt at the pulses, median / 95th percentile", spreadWords(s.tilt_deg, "deg")},
      {formatted("Pulses within %.0f mm and %.0f deg", kNear_mm, kNear_deg), nearWords(session)},
      {"Time guided", timeWords(s.guided_s)}};
  if (s.guided_s) {
    rows.push_back(
        {"of this off target", timeWords(s.off_target_s) + shareWords(*s.off_target_s, *s.guided_s)});
    rows.push_back(
        {"of this with head or coil lost", timeWords(s.lost_s) + shareWords(*s.lost_s, *s.guided_s)});
  }
  rows.push_back({"Face lost / coil lost / faults",
                  formatted("%d / %d / %d times", s.face_losses, s.coil_losses, s.faults)});
  return headingHtml("Navigation accuracy") + factsHtml(rows);
}

std::string figuresPart(const casefile::KeptSession& session) {
  std::vector<double> distance_mm, tilt_deg;
  std::vector<PlacedPulse> places;
  for (const auto& [pulse, is_excluded, note] : session.pulses.pulses) {
    if (!pulse.offset || !pulse.target) continue;
    const auto target_T_coil = pulse.target->mri_T_target.inverse() * *pulse.mri_T_coil();
    const Eigen::Vector3d centre_mm = target_T_coil.translation_mm();
    places.push_back(
        {centre_mm.x(), centre_mm.y(), pulse.status == casefile::PulseStatus::on_target, is_excluded});
    if (is_excluded) continue;
    distance_mm.push_back(pulse.offset->distance_mm);
    tilt_deg.push_back(pulse.offset->tilt_deg);
  }
  if (places.empty()) return {};
  const guidance::Tolerance tolerance{};
  return headingHtml("Pulses against their targets") +
         histogramSvg("Distance", "mm", distance_mm, kDistanceBin_mm, kNear_mm) +
         histogramSvg("Tilt", "deg", tilt_deg, kTiltBin_deg, tolerance.tilt_rad * kDegPerRad) +
         placesSvg("Where the coil's centre was", places, tolerance.lateral_mm) +
         paragraphHtml(
             "Filled circle: on target. Open square: outside the tolerance. Grey cross: excluded, in "
             "no bar. Dashed: 2 mm, and the tolerance of tilt and place.");
}

std::string exceptionsPart(const casefile::KeptSession& session) {
  std::vector<TableRow> rows;
  std::size_t all = 0;
  for (const auto& [pulse, is_excluded, note] : session.pulses.pulses) {
    if (!is_excluded && pulse.status == casefile::PulseStatus::on_target) continue;
    if (++all <= kMostRows)
      rows.push_back({formatted("%d", pulse.number), pulse.utc,
                      is_excluded ? "excluded" : toString(pulse.status), is_excluded ? note : pulse.reason});
  }
  if (rows.empty()) return {};
  return headingHtml("Pulses not on target, or excluded") +
         tableHtml({"pulse", "time (UTC)", "status", "reason"}, rows) +
         (all > kMostRows ? paragraphHtml(formatted("%zu more: see pulses.csv.", all - kMostRows)) : "");
}

std::string eventsPart(const casefile::KeptSession& session) {
  std::vector<TableRow> rows;
  for (const auto& event : session.events)
    if (rows.size() < kMostRows) rows.push_back({event.utc, event.event, withoutFolders(event.detail)});
  if (rows.empty()) return {};
  const std::size_t more = session.events.size() - rows.size();
  return headingHtml("Events") + tableHtml({"time (UTC)", "event", "detail"}, rows) +
         (more > 0 ? paragraphHtml(formatted("%zu more: see events.jsonl.", more)) : "");
}

std::string cautionsPart(const SessionSummary& summary) {
  std::string html;
  if (summary.clock_set_s)
    html += paragraphHtml(
        formatted("The computer's clock was set %s by %.0f s during the session. Times of day "
                  "jump there; the column t_s of pulses.csv does not.",
                  *summary.clock_set_s < 0 ? "back" : "forward", std::abs(*summary.clock_set_s)));
  for (const auto& problem : summary.problems) html += paragraphHtml(withoutFolders(problem));
  return html.empty() ? html : headingHtml("Cautions") + html;
}

}  // namespace

std::string sessionReport(const casefile::CaseStore& store, const casefile::KeptSession& session,
                          const ReportOptions& options) {
  const SessionSummary summary = summarise(session);
  const std::string subtitle = "Case " + store.caseId() +
                               (options.has_name && !store.label().empty() ? ", " + store.label() : "") +
                               ", session " + session.name;
  const std::string head = headingHtml("Head") + factsHtml({{"Nasion to inion", kNotRecorded},
                                                            {"Between the preauricular points", kNotRecorded},
                                                            {"Circumference", kNotRecorded},
                                                            {"Hair (gap measured)", kNotRecorded}});
  const std::string foot =
      paragraphHtml("FaceNav " + softwareVersion() + ". Not a medical device: for research and development.");
  return pageHtml("TMS session report", subtitle,
                  sessionPart(store, session, summary) + targetsPart(store, session) +
                      stimulationPart(session, summary) + accuracyPart(session, summary) +
                      figuresPart(session) + exceptionsPart(session) + head + eventsPart(session) +
                      cautionsPart(summary) + foot);
}

void writeSessionReport(const std::filesystem::path& case_folder,
                        const std::filesystem::path& session_folder) {
  const auto store = casefile::CaseStore::open(case_folder);
  writeWholeFile(session_folder / "report.html", sessionReport(store, casefile::readSession(session_folder)),
                 FileAccess::owner_only);
}

}  // namespace facenav::workflow
