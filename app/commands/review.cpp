// facenav sessions CASE and facenav pulses CASE: the stored data of a case's sessions.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands/commands.h"
#include "commands/compare_sessions.h"
#include "facenav/casefile/kept_session.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/core/whole_file.h"
#include "facenav/report/session_review.h"
#include "facenav/review/mep_import.h"
#include "facenav/treat/pulse_fields.h"
#include "idle_options.h"
#include "typed_values.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

using Json = nlohmann::ordered_json;

std::string dumped(const Json& json) {
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json known(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json toJson(const std::optional<report::Spread>& spread) {
  return spread ? Json{{"median", spread->median}, {"p95", spread->p95}} : Json();
}

Json toJson(const report::SessionSummary& s) {
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
          {"at_home", s.is_at_home},
          {"clock_set_s", known(s.clock_set_s)},
          {"predicted_error_mm", known(s.predicted_error_mm)},
          {"alignment", s.alignment ? Json(*s.alignment) : Json()},
          {"meps", s.meps},
          {"problems", s.problems}};
}

void addField(const casefile::Pulse& pulse, Json& json) {
  const auto& field = pulse.field;
  std::optional<double> at_rate;
  if (field && field->rate_A_per_us) at_rate = field->peak * *field->rate_A_per_us;
  json["e_target_v_per_m_per_a_per_us"] = field ? known(field->at_target) : Json();
  json["e_max_v_per_m"] = known(at_rate);
  json["e_max_v_per_m_per_a_per_us"] = field ? Json(field->peak) : Json();
  json["e_max_mm"] = Json();
  if (field)
    json["e_max_mm"] = {field->peak_place.mm.x(), field->peak_place.mm.y(), field->peak_place.mm.z()};
  json["field_tier"] = field ? Json(field->tier) : Json();
  json["field_coil"] = field ? Json(field->coil) : Json();
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
  addField(pulse, json);
  json["excluded"] = reviewed.is_excluded;
  json["note"] = reviewed.note;
  return json;
}

std::string minutes(const std::optional<double>& seconds) {
  if (!seconds) return "-";
  return formatted("%ld:%02ld", std::lround(*seconds) / 60, std::lround(*seconds) % 60);
}

void print(const report::SessionSummary& s) {
  const std::string distance =
      s.distance_mm ? formatted("%.1f/%.1f", s.distance_mm->median, s.distance_mm->p95) : "-";
  std::printf("%-19s %8s %7d %9d %8d %5d %9d %11s %10s %7d %8d%s%s\n", s.name.c_str(),
              minutes(s.duration_s).c_str(), s.pulses, s.on_target, s.outside, s.lost, s.excluded,
              distance.c_str(), minutes(s.off_target_s).c_str(), s.face_losses + s.coil_losses,
              s.adverse_events, s.has_ended ? "" : "  not ended", s.is_at_home ? "  at home" : "");
}

void printNotes(const std::vector<std::string>& problems, const Context& context) {
  if (context.is_quiet) return;
  for (const auto& problem : problems) std::fprintf(stderr, "note: %s\n", problem.c_str());
}

struct PulsesRequest {
  std::filesystem::path case_folder;
  std::string session, reason, by, field_coil;
  std::optional<std::filesystem::path> output;
  std::vector<int> exclude, include;
  std::vector<std::string> set_meps;  // "12=350"
  std::optional<std::filesystem::path> mep_file;
  steps::XdfChoice xdf;
  std::optional<double> offset_s;
  bool is_json = false;

  bool edits() const { return !exclude.empty() || !include.empty() || !set_meps.empty() || mep_file; }
};

/// Reads "12=350": pulse 12, 350 uV; "12=": not known.
casefile::MepEdit mepFrom(const std::string& words, const std::string& by) {
  const auto equals = std::min(words.find('='), words.size());
  const auto number = numberIn(words.substr(0, equals));
  const bool is_pulse = number && *number >= 1 && *number <= 1e9 && *number == std::floor(*number);
  const std::string typed = equals < words.size() ? words.substr(equals + 1) : std::string("-");
  const auto value_uv = numberIn(typed);
  if (!is_pulse || !(value_uv || typed.empty()))
    throw WrongUsage("'" + words + "' is no MEP", "give --set-mep PULSE=MICROVOLTS, as 12=350");
  return {int(*number), value_uv, {}, "typed", by};
}

void enterMeps(const PulsesRequest& request, const std::filesystem::path& folder, const Context& context) {
  std::vector<casefile::MepEdit> typed;
  for (const auto& words : request.set_meps) typed.push_back(mepFrom(words, request.by));
  if (request.mep_file) {
    const auto file =
        steps::readMepFile(*request.mep_file, request.xdf, settingsOf<steps::MepImportLimits>());
    const auto session = casefile::readSessionPulses(folder);
    auto match =
        steps::matchMeps(file, session.pulses, request.offset_s, settingsOf<steps::MepImportLimits>());
    for (const auto& words : match.left_out)
      if (!context.is_quiet)
        std::fprintf(stderr, "note: %s, %s: left out\n", file.name.c_str(), words.c_str());
    if (match.edits.empty())
      throw Error("no MEP is at the time of a pulse", request.mep_file->string(),
                  "is it this session's file?");
    if (!context.is_quiet)
      for (const auto& note : file.notes) std::fprintf(stderr, "note: %s\n", note.c_str());
    for (auto& edit : match.edits) edit.by = request.by;
    typed.insert(typed.end(), match.edits.begin(), match.edits.end());
    if (!context.is_quiet) std::printf("%s\n", steps::mepMatchWords(match, file).c_str());
  }
  casefile::editMeps(folder, typed);
}

void editPulses(const PulsesRequest& request, const std::filesystem::path& folder, const Context& context) {
  std::vector<casefile::PulseEdit> edits;
  for (const int number : request.exclude) edits.push_back({number, true, request.reason, request.by});
  for (const int number : request.include) edits.push_back({number, false, request.reason, request.by});
  casefile::editPulses(folder, edits);
  enterMeps(request, folder, context);
  if (!context.is_quiet && !edits.empty())
    std::printf("%zu excluded, %zu taken in again; nothing was deleted\n", request.exclude.size(),
                request.include.size());
}

void computeFields(const PulsesRequest& request, const casefile::CaseStore& store,
                   const std::filesystem::path& folder, Context& context) {
  if (request.field_coil.empty()) return;
  const int computed = steps::computePulseFields(store, folder, request.field_coil, context.monitor);
  if (!context.is_quiet)
    std::printf("electric field of %d pulses computed; coil %s\n", computed,
                steps::fieldCoilName(request.field_coil).c_str());
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

void addMepOptions(CLI::App& verb, PulsesRequest& request) {
  auto* mep = verb.add_option(
      "--mep", request.mep_file,
      "CSV with utc or t_s, and mep_uv, or an XDF recording with markers and EMG: each MEP goes to the pulse "
      "at its time; the history stays");
  verb.add_option("--offset", request.offset_s,
                  "with --mep: seconds from the file's clock to the session's; default: found, and said")
      ->needs(mep);
  verb.add_option("--emg", request.xdf.emg,
                  "with --mep FILE.xdf: STREAM[:CHANNEL] of the EMG; default: the only one")
      ->needs(mep);
  verb.add_option("--emg-unit", request.xdf.unit, "with --mep FILE.xdf: uV, mV or V; default: as it says")
      ->check(understoodBy([](const std::string& unit) { steps::xdfChoiceFrom(";;" + unit); }))
      ->needs(mep);
  verb.add_option("--markers", request.xdf.markers,
                  "with --mep FILE.xdf: STREAM[:MARKER] of the pulses; default: FaceNav's, or the only one")
      ->needs(mep);
  verb.add_option("--set-mep", request.set_meps, "PULSE=MICROVOLTS, as 12=350; 12= takes it back; repeatable")
      ->check(understoodBy([](const std::string& words) { mepFrom(words, {}); }))
      ->allow_extra_args(false);
}

}  // namespace

void addSessions(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand("sessions", "the sessions of a case, one a line, with their quality");
  struct ReviewRequest {
    std::filesystem::path case_folder;
    std::vector<std::string> compared;
    bool is_json = false;
  };
  auto request = std::make_shared<ReviewRequest>();
  verb->add_option("CASE", request->case_folder, "case folder")->required();
  verb->add_flag("--json", request->is_json, "as JSON");
  verb->add_option("--compare", request->compared,
                   "two sessions A B: how far the coil of B came back to where it was in A (mm, deg)")
      ->expected(2);
  verb->callback([&context, request] {
    if (!request->compared.empty())
      return compareSessions(request->case_folder, request->compared[0], request->compared[1],
                             request->is_json);
    const auto store = casefile::CaseStore::open(request->case_folder);
    const auto sessions = report::summariseSessions(store.folder());
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
  verb->add_option("--by", request->by, "who changes it: name or initials (not the patient's)");
  addMepOptions(*verb, *request);
  verb->add_option("--field", request->field_coil,
                   "computes the electric field of each pulse's pose anew, for this coil: figure8-70, round, "
                   "or a .ccd, .tcd, .nii.gz file");
  verb->callback([&context, request, verb] {
    refuseIdle(*verb, {"--reason"}, {"--exclude", "--include"});
    refuseIdle(*verb, {"--by"}, {"--exclude", "--include", "--mep", "--set-mep"});
    for (const int number : request->exclude)
      if (std::count(request->include.begin(), request->include.end(), number) > 0)
        throw WrongUsage("pulse " + std::to_string(number) + " is excluded and included", "choose one");
    if (!request->exclude.empty() && request->reason.empty())
      throw WrongUsage("a pulse is excluded only with a reason", "give --reason");
    const auto store = casefile::CaseStore::open(request->case_folder);
    const auto folder = casefile::findSession(store.folder(), request->session);
    if (request->edits()) editPulses(*request, folder, context);
    computeFields(*request, store, folder, context);
    const bool changes = request->edits() || !request->field_coil.empty();
    if (!changes || request->output || request->is_json) showPulses(*request, folder, context);
  });
}

}  // namespace facenav::app
