// facenav sessions CASE, facenav pulses CASE and facenav report CASE: what was kept of a case's sessions.

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands/commands.h"
#include "facenav/casefile/kept_session.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/whole_file.h"
#include "facenav/workflow/session_report.h"
#include "facenav/workflow/session_review.h"

namespace facenav::app {
namespace {

using Json = nlohmann::ordered_json;

std::string dumped(const Json& json) {
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json known(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json toJson(const std::optional<workflow::Spread>& spread) {
  return spread ? Json{{"median", spread->median}, {"p95", spread->p95}} : Json();
}

Json toJson(const workflow::SessionSummary& s) {
  return {{"session", s.name},
          {"started_utc", s.started_utc},
          {"duration_s", known(s.duration_s)},
          {"pulses", s.pulses},
          {"on_target", s.on_target},
          {"outside", s.outside},
          {"lost", s.lost},
          {"excluded", s.excluded},
          {"double_triggers", s.double_triggers},
          {"distance_mm", toJson(s.distance_mm)},
          {"tilt_deg", toJson(s.tilt_deg)},
          {"guided_s", known(s.guided_s)},
          {"off_target_s", known(s.off_target_s)},
          {"lost_s", known(s.lost_s)},
          {"face_losses", s.face_losses},
          {"coil_losses", s.coil_losses},
          {"faults", s.faults},
          {"adverse_events", s.adverse_events},
          {"has_ended", s.has_ended},
          {"clock_set_s", known(s.clock_set_s)},
          {"problems", s.problems}};
}

Json toJson(const casefile::ReviewedPulse& reviewed) {
  const casefile::Pulse& pulse = reviewed.pulse;
  Json json{{"pulse", pulse.number},
            {"t_s", known(pulse.t_s)},
            {"utc", pulse.utc},
            {"source", pulse.source},
            {"target", pulse.target ? Json(pulse.target->name) : Json()},
            {"status", toString(pulse.status)},
            {"reason", pulse.reason},
            {"mri_T_coil", Json()}};
  if (const auto mri_T_coil = pulse.mri_T_coil()) {
    const Eigen::Matrix4d matrix = mri_T_coil->matrix();
    json["mri_T_coil"] = Json::array();
    for (int i = 0; i < 16; ++i) json["mri_T_coil"].push_back(matrix(i / 4, i % 4));
  }
  const auto& offset = pulse.offset;
  json["distance_mm"] = offset ? Json(offset->distance_mm) : Json();
  json["lateral_mm"] = offset ? Json(offset->lateral_mm) : Json();
  json["depth_mm"] = offset ? Json(offset->depth_mm) : Json();
  json["tilt_deg"] = offset ? Json(offset->tilt_deg) : Json();
  json["twist_deg"] = offset ? Json(offset->twist_deg) : Json();
  json["gap_mm"] = known(pulse.gap_mm);
  json["predicted_error_mm"] = known(pulse.predicted_error_mm);
  json["intensity_pct"] = known(pulse.intensity_pct);
  json["e_target_v_per_m"] = known(pulse.e_target_v_per_m);
  json["mep_uv"] = known(pulse.mep_uv);
  json["latency_ms"] = known(pulse.latency_ms);
  json["excluded"] = reviewed.is_excluded;
  json["note"] = reviewed.note;
  return json;
}

std::string minutes(const std::optional<double>& seconds) {
  if (!seconds) return "-";
  return formatted("%ld:%02ld", std::lround(*seconds) / 60, std::lround(*seconds) % 60);
}

void print(const workflow::SessionSummary& s) {
  const std::string distance =
      s.distance_mm ? formatted("%.1f/%.1f", s.distance_mm->median, s.distance_mm->p95) : "-";
  std::printf("%-19s %8s %7d %9d %8d %5d %9d %11s %10s %7d %8d%s\n", s.name.c_str(),
              minutes(s.duration_s).c_str(), s.pulses, s.on_target, s.outside, s.lost, s.excluded,
              distance.c_str(), minutes(s.off_target_s).c_str(), s.face_losses + s.coil_losses,
              s.adverse_events, s.has_ended ? "" : "  not ended");
}

void printNotes(const std::vector<std::string>& problems, const Context& context) {
  if (context.is_quiet) return;
  for (const auto& problem : problems) std::fprintf(stderr, "note: %s\n", problem.c_str());
}

struct PulsesRequest {
  std::filesystem::path case_folder;
  std::string session, reason, by;
  std::optional<std::filesystem::path> output;
  std::vector<int> exclude, include;
  bool is_json = false;

  bool edits() const { return !exclude.empty() || !include.empty(); }
};

void editPulses(const PulsesRequest& request, const std::filesystem::path& folder, const Context& context) {
  for (const int number : request.exclude)
    casefile::editPulse(folder, {number, true, request.reason, request.by});
  for (const int number : request.include)
    casefile::editPulse(folder, {number, false, request.reason, request.by});
  if (!context.is_quiet)
    std::printf("%zu excluded, %zu taken in again; nothing was deleted\n", request.exclude.size(),
                request.include.size());
}

void showPulses(const PulsesRequest& request, const std::filesystem::path& folder, const Context& context) {
  const auto session = casefile::readSessionPulses(folder);
  printNotes(session.problems, context);
  auto json = Json::array();
  if (request.is_json)
    for (const auto& pulse : session.pulses) json.push_back(toJson(pulse));
  const std::string content = request.is_json ? dumped(json) : casefile::pulsesCsv(session.pulses);
  if (!request.output) return void(std::fputs(content.c_str(), stdout));
  writeWholeFile(*request.output, content);
  if (!context.is_quiet)
    std::printf("%zu pulses of session %s\n", session.pulses.size(), folder.filename().c_str());
}

}  // namespace

void addSessions(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand("sessions", "the sessions of a case, one a line, with their quality");
  struct ReviewRequest {
    std::filesystem::path case_folder;
    bool is_json = false;
  };
  auto request = std::make_shared<ReviewRequest>();
  verb->add_option("CASE", request->case_folder, "case folder")->required();
  verb->add_flag("--json", request->is_json, "as JSON");
  verb->callback([&context, request] {
    const auto store = casefile::CaseStore::open(request->case_folder);
    const auto sessions = workflow::summariseSessions(store.folder());
    if (request->is_json) {
      auto json = Json::array();
      for (const auto& session : sessions) json.push_back(toJson(session));
      return void(std::fputs(dumped(json).c_str(), stdout));
    }
    if (sessions.empty()) {
      if (!context.is_quiet) std::printf("the case has no sessions\n");
      return;
    }
    std::printf("%-19s %8s %7s %9s %8s %5s %9s %11s %10s %7s %8s\n", "session (UTC)", "min:s", "pulses",
                "on target", "outside", "lost", "excluded", "mm med/p95", "off target", "losses", "adverse");
    for (const auto& session : sessions) {
      print(session);
      printNotes(session.problems, context);
    }
  });
}

void addPulses(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand(
      "pulses", "the pulses of a session as CSV (or JSON), or exclude pulses with a reason");
  auto request = std::make_shared<PulsesRequest>();
  verb->add_option("CASE", request->case_folder, "case folder")->required();
  verb->add_option("SESSION", request->session, "its name, or how it begins; default: the newest");
  verb->add_option("-o,--output", request->output, "pulses.csv to write; default: shown here");
  verb->add_flag("--json", request->is_json, "as JSON");
  verb->add_option("--exclude", request->exclude, "number of a pulse that shall not count; may be repeated")
      ->allow_extra_args(false);
  verb->add_option("--include", request->include, "number of an excluded pulse that shall count again")
      ->allow_extra_args(false);
  verb->add_option("--reason", request->reason, "why it is excluded; kept with it");
  verb->add_option("--by", request->by, "who excludes it: name or initials (not the patient's)");
  verb->callback([&context, request] {
    const auto store = casefile::CaseStore::open(request->case_folder);
    const auto folder = casefile::findSession(store.folder(), request->session);
    if (request->edits()) editPulses(*request, folder, context);
    if (!request->edits() || request->output || request->is_json) showPulses(*request, folder, context);
  });
}

void addReport(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand("report", "a session as one page for the chart, to read and to print");
  struct ReviewRequest {
    std::filesystem::path case_folder;
    std::string session;
    std::optional<std::filesystem::path> output;
    workflow::ReportOptions options;
  };
  auto request = std::make_shared<ReviewRequest>();
  verb->add_option("CASE", request->case_folder, "case folder")->required();
  verb->add_option("SESSION", request->session, "its name, or how it begins; default: the newest");
  verb->add_option("-o,--output", request->output, "report.html to write; default: in the session's folder");
  verb->add_flag("--with-name", request->options.has_name, "adds the case's label (it may be a name)");
  verb->callback([&context, request] {
    const auto store = casefile::CaseStore::open(request->case_folder);
    const auto folder = casefile::findSession(store.folder(), request->session);
    const auto session = casefile::readSession(folder);
    printNotes(session.pulses.problems, context);
    const auto path = request->output.value_or(folder / "report.html");
    writeWholeFile(path, workflow::sessionReport(store, session, request->options), FileAccess::owner_only);
    if (!context.is_quiet) std::printf("%s\n", path.c_str());
  });
}

}  // namespace facenav::app
