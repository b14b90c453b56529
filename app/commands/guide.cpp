// facenav guide CASE poses.csv --target NAME -o guidance.csv

#include <algorithm>
#include <cstdio>

#include "commands/commands.h"
#include "facenav/workflow/guide_poses.h"

namespace facenav::app {

void addGuide(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand(
      "guide", "poses of head and coil -> distance, tilt and twist to a target, frame by frame");
  struct GuideRequest {
    std::filesystem::path case_folder, poses, output;
    std::string target;
  };
  auto request = std::make_shared<GuideRequest>();
  verb->add_option("CASE", request->case_folder, "case folder with targets.json")->required();
  verb->add_option("POSES", request->poses, "poses.csv, tracked with --case and --coil")->required();
  verb->add_option("--target", request->target, "name of the target")->required();
  verb->add_option("-o,--output", request->output, "guidance.csv to write")->required();
  verb->callback([&context, request] {
    const auto store = casefile::CaseStore::open(request->case_folder);
    const auto rows = workflow::guidePoses(store, casefile::readPoses(request->poses), request->target);
    guidance::writeGuidanceCsv(rows, request->output);
    if (context.is_quiet) return;
    const auto on_target = std::count_if(rows.begin(), rows.end(), [](const auto& row) {
      return row.state.state == guidance::State::on_target;
    });
    std::printf("%zu frames, on target in %ld\n", rows.size(), long(on_target));
  });
}

}  // namespace facenav::app
