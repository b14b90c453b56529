// facenav evaluate rigs FOLDER [--rigs DIR]: tests whether faults of the cameras are named correctly.

#include <cstdio>

#include "commands/lab_commands.h"
#include "evaluate/rig_faults.h"

namespace facenav::app {

void addEvaluateRigs(CLI::App& evaluate, Context& context) {
  auto* verb = evaluate.add_subcommand(
      "rigs", "pictures of known rigs: right, out of step, swapped, moved, another rig's: how each is named");
  auto pictures = std::make_shared<std::filesystem::path>();
  auto rigs = std::make_shared<std::filesystem::path>();
  verb->add_option("FOLDER", *pictures, "pictures <camera>_<moment>.jpg|png, cameras of one letter")
      ->required()
      ->check(CLI::ExistingDirectory);
  verb->add_option("--rigs", *rigs, "folder of <a><b>_stereo.yml (default: FOLDER)")
      ->check(CLI::ExistingDirectory);
  verb->callback([&context, pictures, rigs] {
    const auto rows = rigFaults(*pictures, rigs->empty() ? *pictures : *rigs, context.monitor);
    std::printf("%s", sidesTable(rows).c_str());
  });
}

}  // namespace facenav::app
