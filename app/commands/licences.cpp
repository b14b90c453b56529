// facenav licences: the third-party parts of FaceNav with version and licence; as SPDX with --spdx.

#include <cstdio>

#include "commands/commands.h"
#include "facenav/core/licences.h"
#include "facenav/core/whole_file.h"
#include "json_output.h"
#include "software_commit.h"
#include "spdx.h"

namespace facenav::app {
namespace {

struct LicencesRequest {
  bool is_json = false, is_spdx = false;
  std::filesystem::path output = "-";
};

void printParts() {
  std::printf("FaceNav %s: Apache-2.0\n\n", versionInWords().c_str());
  for (const LicensedPart& part : licensedParts())
    std::printf("%-32s %-12s %-44s %-22s %s\n", part.name.c_str(), upstreamVersion(part.version).c_str(),
                part.licence.c_str(), toString(part.use).c_str(), part.package.c_str());
  std::printf(
      "\nDebian's packages bring more libraries along; /usr/share/doc/PACKAGE/copyright has the licence of "
      "each.\n");
}

nlohmann::ordered_json partsAsJson() {
  auto json = nlohmann::ordered_json::array();
  for (const LicensedPart& part : licensedParts())
    json.push_back({{"name", part.name},
                    {"version", part.version},
                    {"licence", part.licence},
                    {"use", toString(part.use)},
                    {"package", part.package}});
  return json;
}

}  // namespace

void addLicences(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand("licences", "the parts of FaceNav that others made, with their licences");
  auto request = std::make_shared<LicencesRequest>();
  auto* json = verb->add_flag("--json", request->is_json, "as JSON");
  auto* spdx = verb->add_flag("--spdx", request->is_spdx, "as a software bill of materials, SPDX 2.3 (JSON)")
                   ->excludes(json);
  verb->add_option("-o,--output", request->output, "with --spdx: file to write; default: standard output")
      ->needs(spdx);
  verb->callback([&context, request] {
    if (request->is_json) return printJson(partsAsJson());
    if (!request->is_spdx) return printParts();
    writeWholeFile(request->output, spdxDocument(), FileAccess::by_umask);
    if (!context.is_quiet && request->output != "-")
      std::fprintf(stderr, "%zu parts in %s\n", licensedParts().size(), request->output.c_str());
  });
}

}  // namespace facenav::app
