// facenav export CASE --as stl -o FOLDER: surfaces and masks for other programs. CASE --as home -o FILE: the
// case to take home.

#include <algorithm>
#include <cstdio>

#include "commands/commands.h"
#include "commands/home.h"
#include "facenav/casefile/case_store.h"
#include "facenav/core/standard_output.h"
#include "typed_values.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

constexpr const char* kHome = "home";

}  // namespace

void addExport(CLI::App& app, Context& context) {
  auto* verb =
      app.add_subcommand("export", "surfaces and masks of a case as files for other programs (RAS mm)");
  struct ExportRequest {
    std::filesystem::path case_folder, output;
    std::vector<std::string> formats;
    bool replace = false;
    HomeExportRequest home;
  };
  auto request = std::make_shared<ExportRequest>();
  verb->add_option("CASE", request->case_folder, "case folder")->required();
  verb->add_option(
          "--as", request->formats,
          "one or more of: " + steps::namesOf(context.registrations.exporters) +
              "; or home: one file without MRI and name, with the face and the expert's pose, for use "
              "near home ('facenav import', 'facenav-gui --home')")
      ->required()
      ->check(understoodBy([&context](const std::string& format) {
        if (format != kHome) context.registrations.exporters.create(format);
      }));
  verb->add_option("-o,--output", request->output, "folder to write into; of home: the file")->required();
  verb->add_option("--target", request->home.target,
                   "of home: the expert's pose ('facenav target --from-session'); default: the only one");
  verb->add_option(
      "--coil", request->home.coil.words,
      "of home: the expert's coil, its name in the library or its coil.json; default: by its name");
  addCoilLibraryOption(*verb, request->home.coil.library);
  verb->add_option("--by", request->home.by,
                   "of home: who releases it, kept in the file; default: \"clinic\"");
  verb->add_flag("--replace", request->replace, "overwrite files of the same name");
  verb->callback([&context, request, verb] {
    auto& formats = request->formats;
    std::sort(formats.begin(), formats.end());
    formats.erase(std::unique(formats.begin(), formats.end()), formats.end());
    const bool is_home = std::count(formats.begin(), formats.end(), kHome) > 0;
    if (is_home && formats.size() > 1)
      throw WrongUsage("'home' is one file, not files in a folder", "export it alone");
    for (const char* of_home : {"--target", "--coil", "--by"})
      if (!is_home && verb->get_option(of_home)->count() > 0)
        throw WrongUsage(std::string(of_home) + " does nothing here", "give it with --as home");
    const auto store = casefile::CaseStore::open(request->case_folder);
    if (is_home) {
      request->home.output = request->output;
      request->home.replaces = request->replace;
      return exportHomeCase(context, store, request->home);
    }
    if (isStandardOutput(request->output))
      throw WrongUsage("surfaces and masks are several files, not one for standard output", "name a folder");
    std::vector<std::unique_ptr<casefile::Exporter>> exporters;  // checks all names before a file is written
    for (const auto& format : request->formats)
      exporters.push_back(context.registrations.exporters.create(format));
    for (const auto& exporter : exporters)
      for (const auto& path : exporter->write(store, request->output, request->replace, context.monitor))
        if (!context.is_quiet) std::printf("%s\n", path.c_str());
  });
}

}  // namespace facenav::app
