// facenav support-bundle [CASE] -o FILE: what helps to find a fault, without images and names.

#include <cstdio>

#include "commands/commands.h"
#include "support/support_bundle.h"
#include "typed_values.h"

namespace facenav::app {

void addSupportBundle(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand(
      "support-bundle", "gathers what helps to find a fault, without images and names, in one file");
  struct Request {
    BundleRequest bundle;
    std::filesystem::path output;
  };
  auto request = std::make_shared<Request>();
  verb->add_option("CASE", request->bundle.case_folder, "case folder: its outline is added");
  verb->add_option("--log", request->bundle.log,
                   "text that a program printed: its lines are added, scrubbed");
  verb->add_option("-o,--output", request->output, "archive to write (.zip)")
      ->required()
      ->check(namedLike({".zip"}, "a support bundle"));
  verb->callback([&context, request] {
    const ZipEntries entries = supportBundle(request->bundle);
    writeZip(entries, request->output);
    if (context.is_quiet) return;
    std::printf("written: %s\n", request->output.c_str());
    for (const auto& [name, content] : entries)
      std::printf("  %-14s %zu bytes\n", name.c_str(), content.size());
    std::printf("No images, poses, dates or names are in it. Look through it before you send it.\n");
  });
}

}  // namespace facenav::app
