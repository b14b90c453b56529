// facenav export CASE --as stl -o FOLDER: surfaces and masks for other programs.

#include <cstdio>

#include "commands/commands.h"
#include "facenav/casefile/case_store.h"

namespace facenav::app {

void addExport(CLI::App& app, Context& context) {
  auto* verb =
      app.add_subcommand("export", "surfaces and masks of a case as files for other programs (RAS mm)");
  struct ExportRequest {
    std::filesystem::path case_folder, output;
    std::vector<std::string> formats;
    bool replace = false;
  };
  auto request = std::make_shared<ExportRequest>();
  verb->add_option("CASE", request->case_folder, "case folder")->required();
  verb->add_option("--as", request->formats,
                   "one or more of: " + workflow::namesOf(context.registrations.exporters))
      ->required();
  verb->add_option("-o,--output", request->output, "folder to write into")->required();
  verb->add_flag("--replace", request->replace, "overwrite files of the same name");
  verb->callback([&context, request] {
    const auto store = casefile::CaseStore::open(request->case_folder);
    std::vector<std::unique_ptr<casefile::Exporter>> exporters;  // checks all names before a file is written
    for (const auto& format : request->formats)
      exporters.push_back(context.registrations.exporters.create(format));
    for (const auto& exporter : exporters)
      for (const auto& path : exporter->write(store, request->output, request->replace, context.monitor))
        if (!context.is_quiet) std::printf("%s\n", path.c_str());
  });
}

}  // namespace facenav::app
