// facenav worklist DIR, facenav label CASE and facenav check CASE: the radiographer's list of cases, their
// labels, a case's import check, and the sign-off.

#include <cstdio>

#include "commands/commands.h"
#include "facenav/casefile/navigation_check_file.h"
#include "facenav/casefile/sign_off.h"
#include "facenav/prepare/sign_off_gate.h"
#include "json_output.h"
#include "navigation_sheet.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const casefile::WorklistEntry& entry) {
  if (!entry.problem.empty()) return {{"folder", entry.folder.string()}, {"problem", entry.problem}};
  return {{"folder", entry.folder.string()}, {"case_id", entry.case_id},
          {"state", toString(entry.state)},  {"created_utc", entry.created_utc},
          {"checked_by", entry.checked_by},  {"rejection", entry.rejection},
          {"findings", entry.findings},      {"label", entry.label}};
}

void print(const casefile::WorklistEntry& entry) {
  const std::string name = entry.folder.filename().string();
  if (!entry.problem.empty())
    return void(std::printf("%-24s unreadable: %s\n", name.c_str(), entry.problem.c_str()));
  std::printf("%-24s %-9s %s  %zu finding(s)%s%s%s%s%s%s\n", name.c_str(), toString(entry.state).c_str(),
              entry.created_utc.c_str(), entry.findings.size(),
              entry.checked_by.empty() ? "" : "  checked by ", entry.checked_by.c_str(),
              entry.rejection.empty() ? "" : "  rejected by ", entry.rejection.c_str(),
              entry.label.empty() ? "" : "  ", entry.label.c_str());
}

/// Says who looked at the model or rejected the scan, when, and whether that still holds.
std::string signedInWords(const casefile::SignOffStatus& status) {
  if (const auto& rejection = status.rejection)
    return "rejected by " + rejection->by + " at " + rejection->utc + ": " + rejection->reason;
  if (!status.last) return "not signed off";
  std::string words = "signed off by " + status.last->by + " at " + status.last->utc;
  if (!status.last->note.empty()) words += " (" + status.last->note + ")";
  if (status.has_draft) words += "; void: a correction of the brain is unfinished";
  for (const auto& file : status.changed)
    words += (&file == &status.changed.front() ? "; void, changed since: " : ", ") + file;
  return words;
}

Json signedJson(const casefile::SignOffStatus& status) {
  if (!status.last) return nullptr;
  return {{"by", status.last->by},
          {"utc", status.last->utc},
          {"note", status.last->note},
          {"holds", status.holds()},
          {"changed", status.changed},
          {"has_draft", status.has_draft},
          {"brain_ml", status.last->brain_ml ? Json(*status.last->brain_ml) : Json()}};
}

Json checkJson(const casefile::CaseStore& store) {
  Json json{{"verdict", nullptr}, {"fit_for_navigation", Json::array()}, {"measures", Json::array()}};
  if (const auto check = casefile::navigationCheckOf(store)) {
    json["verdict"] = toString(check->verdict());
    for (const auto& finding : check->findings)
      json["fit_for_navigation"].push_back({{"topic", toString(finding.topic)},
                                            {"verdict", toString(finding.verdict)},
                                            {"finding", finding.finding},
                                            {"ask", finding.ask}});
    for (const auto& measure : check->measures)
      json["measures"].push_back({{"name", measure.name},
                                  {"value_mm", measure.value_mm},
                                  {"uncertainty_mm", measure.uncertainty_mm},
                                  {"is_lower_bound", measure.is_lower_bound},
                                  {"is_usual", measure.isUsual()}});
  }
  json["findings"] = store.findings();
  const auto status = casefile::signOffStatus(store);
  json["sign_off"] = signedJson(status);
  json["rejection"] = nullptr;
  if (const auto& rejection = status.rejection)
    json["rejection"] = {{"by", rejection->by}, {"utc", rejection->utc}, {"reason", rejection->reason}};
  return json;
}

}  // namespace

void addWorklist(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand("worklist", "the cases in a folder: state, age, findings, one a line");
  struct WorklistRequest {
    std::filesystem::path folder;
    bool is_json = false;
  };
  auto request = std::make_shared<WorklistRequest>();
  verb->add_option("DIR", request->folder, "folder that holds case folders")->required();
  verb->add_flag("--json", request->is_json, "as JSON");
  verb->callback([request] {
    const auto entries = casefile::listCases(request->folder);
    if (!request->is_json) {
      for (const auto& entry : entries) print(entry);
      return;
    }
    auto json = Json::array();
    for (const auto& entry : entries) json.push_back(toJson(entry));
    printJson(json);
  });
  (void)context;
}

void addLabel(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand("label", "show or set what a case is called in lists");
  struct WorklistRequest {
    std::filesystem::path case_folder;
    std::optional<std::string> label;
    bool is_json = false;
  };
  auto request = std::make_shared<WorklistRequest>();
  verb->add_option("CASE", request->case_folder, "case folder")->required();
  verb->add_option("LABEL", request->label, "its new label; '' takes it away");
  verb->add_flag("--json", request->is_json, "as JSON");
  verb->callback([&context, request] {
    const auto store = casefile::CaseStore::open(request->case_folder);
    if (request->label) store.setLabel(*request->label);
    if (request->is_json) return printJson({{"label", store.label()}});
    if (!context.is_quiet) std::printf("%s\n", store.label().c_str());
  });
}

void addCheck(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand("check", "show a case's import check and, with --by, sign the case off");
  struct WorklistRequest {
    std::filesystem::path case_folder;
    casefile::SignOffRequest sign_off;
    bool is_json = false;
    std::string rejected_for;
  };
  auto request = std::make_shared<WorklistRequest>();
  verb->add_option("CASE", request->case_folder, "case folder")->required();
  verb->add_option("--by", request->sign_off.by,
                   "sign off: name or initials of who looked at the model (not the patient's)");
  verb->add_flag("--acknowledge-findings", request->sign_off.acknowledges_findings,
                 "every finding was looked at");
  auto* note = verb->add_option("--note", request->sign_off.note,
                                "kept with the sign-off; a scan that is not usable needs it as the reason");
  verb->add_option("--reject", request->rejected_for,
                   "instead of signing off: why the scan is not to be used (with --by)")
      ->excludes(note);
  verb->add_flag("--json", request->is_json, "as JSON");
  verb->callback([&context, request] {
    const bool is_signing = !request->sign_off.by.empty();
    if (!is_signing && (request->sign_off.acknowledges_findings || !request->sign_off.note.empty()))
      throw WrongUsage("no name given: say who checked the case", "give --by");
    const auto store = casefile::CaseStore::open(request->case_folder);
    if (!context.is_quiet && !request->is_json) {
      if (const auto check = casefile::navigationCheckOf(store)) printNavigationCheck(*check);
      for (const auto& finding : store.findings()) std::printf("note: %s\n", finding.c_str());
    }
    if (!request->rejected_for.empty()) {
      casefile::rejectScan(store, request->sign_off.by, request->rejected_for);
      if (request->is_json) return printJson(checkJson(store));
      if (!context.is_quiet)
        std::printf("rejected by %s: %s\n", request->sign_off.by.c_str(), request->rejected_for.c_str());
      return;
    }
    if (is_signing) {
      const auto sign_off = steps::signOffChecked(store, request->sign_off);
      if (sign_off.brain_ml && !context.is_quiet && !request->is_json)
        std::printf("brain: %.0f ml\n", *sign_off.brain_ml);
    }
    if (request->is_json) return printJson(checkJson(store));
    if (!context.is_quiet) std::printf("%s\n", signedInWords(casefile::signOffStatus(store)).c_str());
  });
}

}  // namespace facenav::app
