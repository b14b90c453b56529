// facenav export CASE --as stl -o FOLDER: surfaces and masks for other programs. CASE --as brainsight -o
// FILE: targets and pulses for another navigator. CASE --as home -o FILE: the case to take home. CASE --as
// dicom-mr --source DICOM -o FOLDER (or dicom-seg, -o FILE): the plan for the hospital's archive.

#include <algorithm>
#include <cstdio>

#include "commands/commands.h"
#include "commands/home.h"
#include "facenav/casefile/case_store.h"
#include "facenav/core/error.h"
#include "facenav/core/standard_output.h"
#include "facenav/plan/export_dicom.h"
#include "facenav/plan/export_other.h"
#include "typed_values.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

constexpr const char* kHome = "home";
constexpr const char *kDicomMr = "dicom-mr", *kDicomSeg = "dicom-seg";

struct ExportRequest {
  std::filesystem::path case_folder, output, source;
  std::vector<std::string> formats, targets;
  std::string session, subject;
  bool replace = false;
  HomeExportRequest home;
};

bool isDicom(const std::string& name) { return name == kDicomMr || name == kDicomSeg; }

bool isOther(const std::string& name) {
  for (const auto& format : interop::formats())
    if (format.name == name) return true;
  return false;
}

void requireOutput(const ExportRequest& request) {
  if (request.output.empty()) throw CLI::RequiredError("--output");
}

void exportSurfaces(const Context& context, const casefile::CaseStore& store, const ExportRequest& request) {
  requireOutput(request);
  if (isStandardOutput(request.output))
    throw WrongUsage("surfaces and masks are several files, not one for standard output", "name a folder");
  std::vector<std::unique_ptr<casefile::Exporter>> exporters;  // checks all names before a file is written
  for (const auto& format : request.formats)
    exporters.push_back(context.registrations.exporters.create(format));
  for (const auto& exporter : exporters)
    for (const auto& path : exporter->write(store, request.output, request.replace, context.monitor))
      if (!context.is_quiet) std::printf("%s\n", path.c_str());
}

void exportHome(Context& context, const casefile::CaseStore& store, ExportRequest& request) {
  requireOutput(request);
  if (request.targets.size() > 1) throw WrongUsage("a case goes home with one target");
  request.home.target = request.targets.empty() ? "" : request.targets.front();
  request.home.output = request.output;
  request.home.replaces = request.replace;
  exportHomeCase(context, store, request.home);
}

void exportDicom(const Context& context, const casefile::CaseStore& store, const ExportRequest& request) {
  requireOutput(request);
  if (isStandardOutput(request.output))
    throw WrongUsage("a DICOM series or object is not written to standard output", "name a place for it");
  if (request.source.empty())
    throw WrongUsage(
        "the case holds no patient's name, study or frame of reference; they are in the files that it was "
        "prepared from",
        "give their folder with --source");
  const bool is_series = request.formats.front() == kDicomMr;
  const auto write = is_series ? steps::exportDicomMr : steps::exportDicomSegments;
  const auto exported =
      write(store, {request.targets, request.source, request.output, request.replace}, context.monitor);
  if (context.is_quiet) return;
  for (const auto& target : exported.targets) std::printf("drawn: '%s' and its coil\n", target.c_str());
  std::printf("%s: %d %s, with the patient's name\n", request.output.c_str(), exported.images,
              is_series ? "images" : "object");
}

void exportOther(const Context& context, const casefile::CaseStore& store, const ExportRequest& request) {
  if (request.formats.size() > 1)
    throw WrongUsage("one format of another program at a time", "name one with --as");
  const auto exported = steps::exportOther(store, {request.formats.front(), request.targets, request.session,
                                                   request.output, request.replace, request.subject});
  if (context.is_quiet) return;
  for (const auto& note : exported.notes) std::printf("note: %s\n", note.c_str());
  if (isStandardOutput(exported.path)) return;
  std::printf("%s: %d targets", exported.path.c_str(), exported.targets);
  if (exported.pulses > 0) std::printf(", %d pulses", exported.pulses);
  std::printf("\n");
}

void requireFormat(const Context& context, const std::string& format) {
  if (format == kHome || isDicom(format) || isOther(format)) return;
  try {
    context.registrations.exporters.create(format);
  } catch (const Error& error) {
    throw Error(std::string(error.what()) + "; for another program: " + interop::namesOfWritten() +
                "; or dicom-mr, dicom-seg; or home");
  }
}

void addOptions(CLI::App& verb, ExportRequest& request, const Context& context) {
  verb.add_option("CASE", request.case_folder, "case folder")->required();
  verb.add_option("--as", request.formats,
                  "one or more of: " + steps::namesOf(context.registrations.exporters) +
                      "; or one for another program: " + interop::namesOfWritten() +
                      "; or dicom-mr: the MRI as a DICOM series for the archive, target and planned coil "
                      "drawn into it; or dicom-seg: these as one segmentation object (both need --source; "
                      "'facenav pacs store' sends them); or home: one file without MRI and "
                      "name, with the face and the expert's pose, for use "
                      "near home ('facenav import', 'facenav-gui --home')")
      ->required()
      ->check(understoodBy([&context](const std::string& format) { requireFormat(context, format); }));
  verb.add_option(
      "-o,--output", request.output,
      "folder to write surfaces into; else the file (for another program by default here, under its usual "
      "name)");
  verb.add_option(
          "--target", request.targets,
          "for another program: this target alone (several times: these); of dicom-mr and dicom-seg: the "
          "targets to draw, by default the only one; of home: the expert's pose "
          "('facenav target --from-session'), by default the only one")
      ->allow_extra_args(false);
  verb.add_option("--session", request.session,
                  "for another program: the pulses of this session; default: of all, if the file holds both");
  verb.add_option("--subject", request.subject,
                  "of nibs-bids: the person's label in the data set, letters and digits; default: the case's "
                  "label if it is a code, else its random id");
  verb.add_option("--source", request.source,
                  "of dicom-mr and dicom-seg: folder of the DICOM files that the case was prepared from; "
                  "patient and study are "
                  "taken from there");
  verb.add_option(
      "--coil", request.home.coil.words,
      "of home: the expert's coil, its name in the library or its coil.json; default: by its name");
  addCoilLibraryOption(verb, request.home.coil.library);
  verb.add_option("--by", request.home.by, "of home: who releases it, kept in the file; default: \"clinic\"");
  verb.add_flag("--replace", request.replace, "overwrite files of the same name");
}

/// Refuses options that the formats do not use.
void requireUsedOptions(const CLI::App& verb, const ExportRequest& request, bool is_home, bool is_dicom,
                        bool is_other) {
  const auto refuse = [&verb](const std::string& option, bool is_used, const char* remedy) {
    if (!is_used && verb.get_option(option)->count() > 0)
      throw WrongUsage(option + " does nothing here", remedy);
  };
  if (is_other && request.formats.front() == "nibs-bids" && request.output.empty())
    throw CLI::RequiredError("--output");
  if (is_home && request.formats.size() > 1)
    throw WrongUsage("'home' is one file, not files in a folder", "export it alone");
  if (is_dicom && request.formats.size() > 1)
    throw WrongUsage("a DICOM series or object has a place of its own", "export it alone");
  for (const char* of_home : {"--coil", "--by"}) refuse(of_home, is_home, "give it with --as home");
  refuse("--target", is_home || is_dicom || is_other,
         "give it with --as home, dicom-mr, dicom-seg or the format of another program");
  const bool is_set = is_other && request.formats.front() == "nibs-bids";
  refuse("--subject", is_set, "give it with --as nibs-bids");
  refuse("--source", is_dicom, "give it with --as dicom-mr or dicom-seg");
  refuse("--session", is_other, "give it with the format of another program");
}

}  // namespace

void addExport(CLI::App& app, Context& context) {
  auto* verb =
      app.add_subcommand("export",
                         "surfaces and masks of a case as files for other programs (RAS mm); targets and "
                         "pulses for other navigators; the plan as a DICOM series; a case to take home");
  auto request = std::make_shared<ExportRequest>();
  addOptions(*verb, *request, context);
  verb->callback([&context, request, verb] {
    auto& formats = request->formats;
    std::sort(formats.begin(), formats.end());
    formats.erase(std::unique(formats.begin(), formats.end()), formats.end());
    const bool is_home = std::count(formats.begin(), formats.end(), kHome) > 0;
    const bool is_dicom = std::any_of(formats.begin(), formats.end(), isDicom);
    const bool is_other = std::any_of(formats.begin(), formats.end(), isOther);
    requireUsedOptions(*verb, *request, is_home, is_dicom, is_other);
    const auto store = casefile::CaseStore::open(request->case_folder);
    if (is_home) return exportHome(context, store, *request);
    if (is_dicom) return exportDicom(context, store, *request);
    if (is_other) return exportOther(context, store, *request);
    exportSurfaces(context, store, *request);
  });
}

}  // namespace facenav::app
