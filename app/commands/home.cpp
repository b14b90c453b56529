// facenav face-case RECORDING -o CASE, facenav import CASE FILE, and `facenav export CASE --as home`: cases
// that need no MRI. Files of other programs: import_other.h.

#include "commands/home.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands/commands.h"
#include "commands/import_field.h"
#include "commands/import_other.h"
#include "facenav/core/error.h"
#include "facenav/core/standard_output.h"
#include "facenav/home/returned_session.h"
#include "facenav/plan/expert_pose.h"
#include "typed_values.h"
#include "wrong_usage.h"

namespace facenav::app {

void exportHomeCase(Context& context, const casefile::CaseStore& store, const HomeExportRequest& request) {
  steps::HomeOrder order;
  order.target = request.target;
  order.coil = request.coil.words;
  order.coil_library = coil_library::coilLibrary(request.coil.library);
  if (!request.by.empty()) order.released_by = request.by;
  if (!isStandardOutput(request.output) && std::filesystem::exists(request.output) && !request.replaces)
    throw Error("the file exists already", request.output.string(), "choose another name, or --replace");
  const auto detector = context.registrations.face_detector();
  const auto made = steps::exportHome(*detector, store, order, request.output, context.monitor);
  if (context.is_quiet) return;
  if (!isStandardOutput(request.output))
    std::printf("%s: %.1f MB, no MRI, no name\n", request.output.c_str(), double(made.bytes) / 1e6);
  std::printf("expert's pose '%s': %s\n", made.target.name.c_str(),
              steps::inWords(*made.target.expert).c_str());
  if (made.face) std::printf("%s\n", faceFinding(*made.face).c_str());
}

void addFaceCase(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand(
      "face-case",
      "a case without an MRI: the face that a recording shows is its model (with dots; or, with the coil's "
      "marker at rest beside it, a film of the turning head or a plain pair)");
  struct FaceCaseRequest {
    steps::FaceCaseOrder order;
    std::string from;
    CoilChoice coil;
  };
  auto request = std::make_shared<FaceCaseRequest>();
  auto& order = request->order;
  verb->add_option("RECORDING", order.recording, "recording of the first visit")->required();
  verb->add_option("-o,--output", order.case_folder, "case folder to make")
      ->required()
      ->check(folderToMake());
  verb->add_option("--label", order.label, "what the case is called in lists; default: nothing");
  verb->add_option("--using", request->from,
                   "measures in these pictures alone: dots, plain or film; default: the best")
      ->check(CLI::IsMember({"dots", "plain", "film"}));
  verb->add_option("--coil", request->coil.words,
                   "the coil whose marker is seen, by name or coil.json; default: the recording's coil.json");
  addCoilLibraryOption(*verb, request->coil.library);
  verb->add_flag(
      "--replace", order.replaces,
      "replaces a face case there; its targets and sessions go, for they belong to the old measurement");
  verb->callback([&context, request] {
    request->order.from = measured_face::alignedFrom(request->from);
    if (!request->coil.words.empty()) request->order.coil = coilOf(request->coil);
    const auto store = steps::makeFaceCase(context.registrations, request->order, context.monitor);
    if (context.is_quiet) return;
    for (const auto& finding : store.findings()) std::printf("note: %s\n", finding.c_str());
    std::printf("%s: case %s\n", request->order.case_folder.c_str(), store.caseId().c_str());
  });
}

namespace {

struct ImportRequest {
  std::filesystem::path case_folder, file;
  bool is_json = false;
  ImportOtherRequest other;
  ImportFieldRequest field;
};

void importField(const Context& context, ImportRequest& request) {
  auto& field = request.field;
  field.order.file = request.file;
  field.order.t1 = request.other.order.t1;
  field.is_dry_run = request.other.is_dry_run;
  field.is_json = request.is_json;
  importFieldFile(context, request.case_folder, field);
}

void importSession(const Context& context, const ImportRequest& request) {
  const auto store = casefile::CaseStore::open(request.case_folder);
  const auto returned = steps::importReturned(store, request.file);
  using Outcome = steps::ReturnedOutcome;
  if (request.is_json) {
    const nlohmann::ordered_json json{{"case_id", store.caseId()},
                                      {"session", returned.folder.filename().string()},
                                      {"pulses", returned.pulses},
                                      {"outcome", returned.outcome == Outcome::added       ? "added"
                                                  : returned.outcome == Outcome::completed ? "completed"
                                                                                           : "unchanged"}};
    std::printf("%s\n", json.dump(1).c_str());
  } else if (!context.is_quiet) {
    std::printf("%s\n", steps::inWords(returned).c_str());
  }
}

void importCase(const Context& context, const ImportRequest& request) {
  const auto store = steps::importHome(request.file, request.case_folder);
  const auto home = steps::openHomeCase(store.folder());
  if (request.is_json) {
    const nlohmann::ordered_json json{{"case_id", store.caseId()},
                                      {"target", home.target.name},
                                      {"coil", home.coil.name},
                                      {"expert", steps::inWords(*home.target.expert)}};
    std::printf("%s\n", json.dump(1).c_str());
  } else if (!context.is_quiet) {
    std::printf("case %s: '%s', %s\n", store.caseId().c_str(), home.target.name.c_str(),
                steps::inWords(*home.target.expert).c_str());
  }
}

}  // namespace

void addImport(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand(
      "import",
      "a file of another navigator -> targets and sessions of the case; an electric field of SimNIBS -> the "
      "target that it was computed for; a file that the clinic gave for use "
      "at home -> case folder; a session that came back from home -> a session of the case, marked \"at "
      "home\"");
  auto request = std::make_shared<ImportRequest>();
  verb->add_option("CASE", request->case_folder, "case folder to add to; of a file for home: to make")
      ->required();
  verb->add_option("FILE", request->file,
                   "file or session folder of another program, known by its content; or of 'facenav export "
                   "--as home', or the one "
                   "sent back")
      ->required();
  verb->add_flag("--json", request->is_json, "JSON");
  addImportOtherOptions(*verb, request->other);
  addImportFieldOptions(*verb, request->field);
  verb->callback([&context, request] {
    if (isOtherFile(request->file)) {
      if (steps::isFieldFile(request->file)) return importField(context, *request);
      if (!request->field.order.target.empty())
        throw WrongUsage("--target is for an electric field, and this file holds none that is known",
                         "give a .msh, a NIfTI, or an overlay with its --surface");
      request->other.order.file = request->file;
      request->other.is_json = request->is_json;
      return importOtherFile(context, request->case_folder, request->other);
    }
    steps::isReturnedFile(request->file) ? importSession(context, *request) : importCase(context, *request);
  });
}

}  // namespace facenav::app
