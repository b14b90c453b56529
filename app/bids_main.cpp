// facenav-bids BIDS_DIR OUT participant [--participant-label ..] [--table]: the BIDS-App convention. One case
// per T1w image. Exit status 0: all done, 1: at least one failed, 2: wrong usage.

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "bids/bids_batch.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"

namespace {

using namespace facenav;
namespace fs = std::filesystem;

struct Request {
  fs::path dataset, output;
  std::string level;
  std::vector<std::string> labels;
  bool is_table_only = false;
};

int printTable(const std::vector<app::BidsResult>& results) {
  const std::string table = app::toTable(results);
  std::fputs(table.c_str(), stdout);
  for (const auto& result : results)
    if (result.state == app::BidsState::failed) return 1;
  return 0;
}

int runBatch(const Request& request) {
  const auto images = app::findT1Images(request.dataset, request.labels);
  std::vector<app::BidsResult> results;
  if (request.is_table_only) {
    for (const auto& image : images) results.push_back(app::foundImage(image, request.output));
    return printTable(results);
  }
  fs::create_directories(request.output);
  app::writeDerivativesDescription(request.output, request.dataset, FACENAV_VERSION);
  const fs::path facenav = fs::read_symlink("/proc/self/exe").parent_path() / "facenav";
  for (const auto& image : images) {
    std::fprintf(stderr, "[%zu/%zu] %s\n", results.size() + 1, images.size(), image.prefix().c_str());
    results.push_back(app::prepareImage(image, request.output, facenav));
  }
  return printTable(results);
}

}  // namespace

int main(int argc, char** argv) {
  Request request;
  CLI::App cli("FaceNav: prepares every T1w image of a BIDS dataset (BIDS-App)", "facenav-bids");
  cli.add_option("bids_dir", request.dataset, "the dataset")->required();
  cli.add_option("output_dir", request.output, "derivatives: one case per image; what is there is kept")
      ->required();
  cli.add_option("analysis_level", request.level, "participant")
      ->required()
      ->check(CLI::IsMember({"participant"}));
  cli.add_option("--participant-label,--participant_label", request.labels,
                 "only these, with or without 'sub-'");
  cli.add_flag("--table", request.is_table_only,
               "runs nothing: the table of what is there, failed or not run");
  cli.set_version_flag("--version,-v", FACENAV_VERSION);
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return cli.exit(error) == 0 ? 0 : 2;
  }
  try {
    return runBatch(request);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "facenav-bids: %s\n", error.what());
    return 1;
  }
}
