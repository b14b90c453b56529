#include "facenav/report/session_report.h"

#include <algorithm>
#include <cmath>

#include "facenav/casefile/sign_off.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/core/software_version.h"
#include "facenav/core/whole_file.h"
#include "facenav/core/without_folders.h"
#include "facenav/geometry/rotation.h"
#include "facenav/guidance/guidance.h"
#include "facenav/report/local_time.h"
#include "facenav/report/report_language.h"
#include "facenav/report/review_charts.h"
#include "facenav/report/session_notes.h"
#include "facenav/report/session_review.h"
#include "facenav/scene/png.h"
#include "report_events.h"
#include "report_field.h"
#include "report_html.h"
#include "report_protocol.h"
#include "report_targets.h"

namespace facenav::report {
namespace {

constexpr const char* kNotRecorded = "not recorded";
constexpr double kNear_mm = 2.0, kNear_deg = 3.0;  // limits of the share of pulses in published sheets
constexpr double kDistanceBin_mm = 0.5, kTiltBin_deg = 1.0;

std::string timeWords(const std::optional<double>& seconds) {
  if (!seconds) return kNotRecorded;
  const long whole = std::lround(*seconds);
  return formatted("%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
}

/// "0:20:05, 0:02:31 of it paused; the program did not run for 0:05:00 in between".
std::string durationWords(const SessionSummary& summary) {
  std::string words = timeWords(summary.duration_s);
  if (summary.paused_s.value_or(0) >= 0.5) words += ", " + timeWords(summary.paused_s) + " of it paused";
  if (summary.away_s.value_or(0) >= 0.5)
    words += "; the program did not run for " + timeWords(summary.away_s) + " in between";
  return words;
}

std::string shareWords(double part, double whole) {
  return whole > 0 ? formatted(" (%.0f %%)", 100.0 * part / whole) : std::string();
}

std::string spreadWords(const std::optional<Spread>& spread, const char* unit) {
  return spread ? formatted("%.1f / %.1f %s", spread->median, spread->p95, unit)
                : std::string("no pulse has a pose");
}

/// True for an event written at each start; a continued session has several.
bool isOfStart(const std::string& event) {
  return event == "alignment" || event == "coil" || event == "override" || event == "protocol";
}

/// Details of all events with that name, the last one last.
std::string detailsOf(const casefile::KeptSession& session, const std::string& event) {
  std::string words, before;
  for (const auto& e : session.events) {
    if (e.event != event || (isOfStart(event) && !words.empty() && e.detail == before)) continue;
    words += (words.empty() ? "" : "; ") + e.detail;
    before = e.detail;
  }
  return words.empty() ? kNotRecorded : words;
}

/// Details that a person wrote, as they are.
Cell writtenCell(const casefile::KeptSession& session, const std::string& event) {
  const std::string words = detailsOf(session, event);
  return words == kNotRecorded ? Cell(words) : keptCell(words);
}

std::string nearWords(const casefile::KeptSession& session) {
  int near = 0, all = 0;
  for (const auto& reviewed : session.pulses.pulses) {
    if (reviewed.is_excluded) continue;
    const auto& offset = reviewed.pulse.offset;
    ++all;
    near += offset && offset->distance_mm <= kNear_mm && offset->tilt_deg <= kNear_deg;
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

std::string mepWords(const casefile::KeptSession& session) {
  std::vector<double> meps_uv;
  for (const auto& reviewed : session.pulses.pulses)
    if (!reviewed.is_excluded && reviewed.pulse.mep_uv) meps_uv.push_back(*reviewed.pulse.mep_uv);
  if (meps_uv.empty()) return kNotRecorded;
  const auto spread = spreadOf(meps_uv);
  return formatted("%zu, median / 95th percentile %.0f / %.0f uV, %zu of them entered after their pulse",
                   meps_uv.size(), spread->median, spread->p95, session.pulses.edited_meps.size());
}

std::string gapWords(const casefile::KeptSession& session) {
  std::vector<double> gaps_mm;
  for (const auto& reviewed : session.pulses.pulses)
    if (!reviewed.is_excluded && reviewed.pulse.gap_mm) gaps_mm.push_back(*reviewed.pulse.gap_mm);
  return gaps_mm.empty() ? kNotRecorded : formatted("median %.1f mm", median(gaps_mm));
}

/// "95 % within 1.4 mm", as everywhere else; an older session stored only the standard error.
std::string errorWords(const casefile::KeptSession& session) {
  std::vector<double> bound_mm, error_mm;
  for (const auto& reviewed : session.pulses.pulses) {
    if (const auto& bound = reviewed.pulse.error_bound_mm) bound_mm.push_back(*bound);
    if (const auto& error = reviewed.pulse.predicted_error_mm) error_mm.push_back(*error);
  }
  if (bound_mm.empty() && error_mm.empty()) return kNotRecorded;
  const bool is_known = !bound_mm.empty();
  const auto& values = is_known ? bound_mm : error_mm;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const std::string range =
      *high - *low < 0.05 ? formatted("%.1f mm", *high) : formatted("%.1f to %.1f mm", *low, *high);
  return is_known ? "95 % within " + range : range + " (one standard error; 95 % not recorded)";
}

std::string joined(const std::vector<std::string>& words, const char* none) {
  std::string all;
  for (const auto& each : words) all += (all.empty() ? "" : "; ") + each;
  return all.empty() ? none : all;
}

/// "coil too warm (151 s); equipment (not ended)".
std::string pauseWords(const casefile::KeptSession& session) {
  std::vector<std::string> reasons, lengths;
  for (const auto& e : session.events) {
    if (e.event == session_events::kPause) {
      reasons.push_back(e.detail.empty() ? "no reason given" : e.detail);
      lengths.resize(reasons.size(), "not ended");
    }
    if (lengths.empty()) continue;
    if (e.event == session_events::kResume) lengths.back() = "ended";
    if (e.event == session_events::kPauseLength) lengths.back() = e.detail;
  }
  for (std::size_t i = 0; i < reasons.size(); ++i) reasons[i] += " (" + lengths[i] + ")";
  return joined(reasons, "none");
}

std::string signOffWords(const casefile::CaseStore& store) {
  try {
    const auto status = casefile::signOffStatus(store);
    if (!status.last) return "not signed off";
    return status.last->by + ", " + localTime(status.last->utc) +
           (status.holds() ? "" : " (no longer valid)");
  } catch (const Error&) {
    return "cannot be read";
  }
}

std::string placeWords(const casefile::KeptSession& session, const SessionSummary& summary) {
  if (!summary.is_at_home) return "here";
  return session.returned_utc ? "at home; the file came back on " + localTime(*session.returned_utc)
                              : "at home";
}

std::string sessionPart(const casefile::CaseStore& store, const casefile::KeptSession& session,
                        const SessionSummary& summary) {
  return headingHtml("Session") +
         factsHtml({{"Start", localTimeAndZone(summary.started_utc)},
                    {"Duration", durationWords(summary)},
                    {"End", summary.end},
                    {"Gone on with", detailsOf(session, "session continued") == kNotRecorded
                                         ? "no"
                                         : detailsOf(session, "session continued")},
                    {"Place", placeWords(session, summary)},
                    {"Operator", writtenCell(session, "operator")},
                    {"Head model checked by", signOffWords(store)},
                    {"Treated without a sign-off",
                     detailsOf(session, "override") == kNotRecorded ? "no" : detailsOf(session, "override")},
                    {"Protocol", detailsOf(session, "protocol")},
                    {"Pauses, with their reasons", pauseWords(session)},
                    {"Pain before (0 to 10)", detailsOf(session, "pain before")},
                    {"Pain after (0 to 10)", detailsOf(session, "pain after")},
                    {"Adverse events", writtenCell(session, "adverse event")}});
}

std::string stimulationPart(const casefile::CaseStore& store, const casefile::KeptSession& session,
                            const SessionSummary& s) {
  const int counted = s.pulses - s.excluded;
  return headingHtml("Stimulation") +
         factsHtml({{"Stimulator (make, model)", detailsOf(session, "stimulator")},
                    {"Coil", detailsOf(session, "coil")},
                    {"Muscles", detailsOf(session, "muscle")},
                    {"Motor threshold (method, criterion, hits of all)", detailsOf(session, "threshold")},
                    {"Intensity", intensityWords(session)},
                    {"MEPs", mepWords(session)},
                    {"Trains (frequency, pulses, pauses)", trainWords(store, session)},
                    {"Pulses", formatted("%d", s.pulses)},
                    {"of these on target", formatted("%d", s.on_target) + shareWords(s.on_target, counted)},
                    {"outside the tolerance", formatted("%d", s.outside) + shareWords(s.outside, counted)},
                    {"with head or coil lost", formatted("%d", s.lost) + shareWords(s.lost, counted)},
                    {"given in a pause (never on target)", formatted("%d", s.in_pause)},
                    {"excluded, with a reason", formatted("%d", s.excluded)},
                    {"Double triggers, not counted", formatted("%d", s.double_triggers)}});
}

std::string accuracyPart(const casefile::KeptSession& session, const SessionSummary& s) {
  std::vector<TableRow> rows{
      {"Alignment of MRI and head", detailsOf(session, "alignment")},
      {"Error of the alignment at the target", errorWords(session)},
      {"Cautions of the alignment", joined(s.alignment_cautions, "none")},
      {"Re-checks of the registration", detailsOf(session, "registration check")},
      {"Coil's tip held to the face, judged by a person", detailsOf(session, session_events::kTip)},
      {"Distance of coil and target at the pulses, median / 95th percentile",
       spreadWords(s.distance_mm, "mm")},
      {"Tilt at the pulses, median / 95th percentile", spreadWords(s.tilt_deg, "deg")},
      {formatted("Pulses within %.0f mm and %.0f deg", kNear_mm, kNear_deg), nearWords(session)},
      {"Time guided, without pauses", timeWords(s.guided_s)}};
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

/// Adds the figure to the report; returns its HTML for the body.
std::string placed(SessionReport::Figure figure, SessionReport& report) {
  report.figures.push_back(std::move(figure));
  return formatted("<img src=\"figure:%zu\">\n", report.figures.size() - 1);
}

std::vector<PlacedPulse> placesOf(const casefile::KeptSession& session) {
  std::vector<PlacedPulse> places;
  for (const auto& reviewed : session.pulses.pulses) {
    const casefile::Pulse& pulse = reviewed.pulse;
    if (!pulse.offset || !pulse.target) continue;
    const auto target_T_coil = pulse.target->mri_T_target.inverse() * *pulse.mri_T_coil();
    const Eigen::Vector3d centre_mm = target_T_coil.translation_mm();
    places.push_back({centre_mm.x(), centre_mm.y(), pulse.status == casefile::PulseStatus::on_target,
                      reviewed.is_excluded});
  }
  return places;
}

std::string figuresPart(const casefile::KeptSession& session, SessionReport& report) {
  const auto places = placesOf(session);
  if (places.empty()) return {};
  std::vector<double> distance_mm, tilt_deg;
  for (const auto& reviewed : session.pulses.pulses) {
    if (reviewed.is_excluded || !reviewed.pulse.offset || !reviewed.pulse.target) continue;
    distance_mm.push_back(reviewed.pulse.offset->distance_mm);
    tilt_deg.push_back(reviewed.pulse.offset->tilt_deg);
  }
  const guidance::Tolerance tolerance{};
  const auto chart = [&](Chart drawn) { return placed({std::move(drawn), {}}, report); };
  return headingHtml("Pulses against their targets") + "<p>" +
         chart(histogramChart("Distance", "mm", distance_mm, kDistanceBin_mm, kNear_mm)) +
         chart(histogramChart("Tilt", "deg", tilt_deg, kTiltBin_deg, tolerance.tilt_rad * kDegPerRad)) +
         chart(placesChart("Where the coil's centre was", places, tolerance.lateral_mm)) +
         chart(driftChart(session.pulses.pulses, PulseColumn::distance)) + "</p>\n" +
         paragraphHtml(
             "Filled circle: on target. Open square: outside the tolerance. Grey cross: excluded, in "
             "no bar. Dashed: 2 mm, and the tolerance of tilt and place.");
}

/// The pictures, two side by side, each over its caption.
std::string picturesPart(const ReportOptions& options, SessionReport& report) {
  if (options.pictures.empty()) return {};
  std::string html = headingHtml("Where the pulses went") + "<table class=\"pictures\">\n";
  for (std::size_t i = 0; i < options.pictures.size(); ++i) {
    const ReportPicture& picture = options.pictures[i];
    html += (i % 2 == 0 ? "<tr><td>" : "<td>") + placed({std::nullopt, picture.image}, report) +
            paragraphHtml(picture.caption) + "</td>";
    if (i % 2 == 1 || i + 1 == options.pictures.size()) html += "</tr>\n";
  }
  return html + "</table>\n";
}

}  // namespace

SessionReport makeSessionReport(const casefile::CaseStore& store, const casefile::KeptSession& session,
                                const ReportOptions& options) {
  const SessionSummary summary = summarise(session);
  SessionReport report;
  report.title = "TMS session report";
  report.page_words = "page %1 of %2";
  report.subtitle = "Case " + store.caseId() +
                    (options.has_name && !store.label().empty() ? ", " + store.label() : "") + ", session " +
                    session.name;
  const std::string head =
      headingHtml("Head") +
      factsHtml({{"Nasion to inion", kNotRecorded},
                 {"Between the preauricular points", kNotRecorded},
                 {"Circumference", kNotRecorded},
                 {"Gap of the coil's centre to the skin (hair, hollows)", gapWords(session)}});
  const std::string foot =
      paragraphHtml("FaceNav " + softwareVersion() + ". Not a medical device: for research and development.");
  report.body = sessionPart(store, session, summary) + targetsPart(store, session) +
                stimulationPart(store, session, summary) + fieldPart(session) + protocolPart(store, session) +
                accuracyPart(session, summary);
  report.body += picturesPart(options, report);
  report.body += figuresPart(session, report);
  report.body += exceptionsPart(session) + head + eventsPart(session) + cautionsPart(summary) + foot;
  return options.language ? inLanguage(std::move(report), *options.language) : report;
}

std::string toHtml(const SessionReport& report) {
  std::string body = report.body;
  for (std::size_t i = 0; i < report.figures.size(); ++i) {
    const std::string place = formatted("<img src=\"figure:%zu\">", i);
    const auto& figure = report.figures[i];
    const std::string drawn =
        figure.chart ? chartSvg(*figure.chart) : pictureHtml(scene::pngOf(figure.picture));
    body.replace(body.find(place), place.size(), drawn);
  }
  return pageHtml(report.language, report.title, report.subtitle, body);
}

std::string sessionReport(const casefile::CaseStore& store, const casefile::KeptSession& session,
                          const ReportOptions& options) {
  return toHtml(makeSessionReport(store, session, options));
}

void writeSessionReport(const std::filesystem::path& case_folder, const std::filesystem::path& session_folder,
                        const ReportOptions& options) {
  const auto store = casefile::CaseStore::open(case_folder);
  const auto page = sessionReport(store, casefile::readSession(session_folder), options);
  writeWholeFile(session_folder / "report.html", page, FileAccess::owner_only);
}

}  // namespace facenav::report
