// facenav worklist DIR, facenav label CASE and facenav check CASE: the radiographer's list of cases, their
// labels, a case's import check, and the sign-off.

#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands/commands.h"
#include "facenav/casefile/navigation_check_file.h"
#include "facenav/casefile/sign_off.h"
#include "facenav/prepare/sign_off_gate.h"
#include "navigation_sheet.h"

namespace facenav::app {
namespace {

nlohmann::ordered_json toJson(const casefile::WorklistEntry& entry) {
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
    auto json = nlohmann::ordered_json::array();
    for (const auto& entry : entries) json.push_back(toJson(entry));
    std::printf("%s\n", json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
  });
  (void)context;
}

void addLabel(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand("label", "show or set what a case is called in lists");
  struct WorklistRequest {
    std::filesystem::path case_folder;
    std::optional<std::string> label;
  };
  auto request = std::make_shared<WorklistRequest>();
  verb->add_option("CASE", request->case_folder, "case folder")->required();
  verb->add_option("LABEL", request->label, "its new label; '' takes it away");
  verb->callback([&context, request] {
    const auto store = casefile::CaseStore::open(request->case_folder);
    if (request->label) store.setLabel(*request->label);
    if (!context.is_quiet) std::printf("%s\n", store.label().c_str());
  });
}

void addCheck(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand("check", "show a case's import check and, with --by, sign the case off");
  struct WorklistRequest {
    std::filesystem::path case_folder;
    casefile::SignOffRequest sign_off;
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
  verb->callback([&context, request] {
    const auto store = casefile::CaseStore::open(request->case_folder);
    if (!context.is_quiet) {
      if (const auto check = casefile::navigationCheckOf(store)) printNavigationCheck(*check);
      for (const auto& finding : store.findings()) std::printf("note: %s\n", finding.c_str());
    }
    if (!request->rejected_for.empty()) {
      casefile::rejectScan(store, request->sign_off.by, request->rejected_for);
      if (!context.is_quiet)
        std::printf("rejected by %s: %s\n", request->sign_off.by.c_str(), request->rejected_for.c_str());
      return;
    }
    if (request->sign_off.by.empty()) {
      if (request->sign_off.acknowledges_findings || !request->sign_off.note.empty())
        steps::signOffChecked(store, request->sign_off);  // throws: no name given
      return;
    }
    const auto sign_off = steps::signOffChecked(store, request->sign_off);
    if (context.is_quiet) return;
    if (sign_off.brain_ml) std::printf("brain: %.0f ml\n", *sign_off.brain_ml);
    std::printf("checked by %s at %s\n", sign_off.by.c_str(), sign_off.utc.c_str());
  });
}

}  // namespace facenav::app
