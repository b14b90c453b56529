// facenav evaluate skin VOLUME..: displacement of the skin by shading, a bright nose, halo, pads, earphones.

#include <cstdio>

#include "commands/lab_commands.h"
#include "evaluate/skin_evaluation.h"
#include "wrong_usage.h"

namespace facenav::app {

void addEvaluateSkin(CLI::App& evaluate, Context& context) {
  auto* verb = evaluate.add_subcommand(
      "skin",
      "how far the skin moves when shading, a bright nose, a halo, pads, earphones or tape are added");
  auto request = std::make_shared<SkinEvaluation>();
  verb->add_option("VOLUME", request->volumes, "scans (NIfTI)")->check(CLI::ExistingFile);
  verb->add_option("--labels", request->labels, "labelled heads of the shared data, painted as T1s")
      ->check(CLI::ExistingFile)
      ->delimiter(',');
  verb->add_option("--only", request->only,
                   "only additions whose name contains this (\"halo\", \"pad\", ..)");
  verb->add_option("--seed", request->seed, "of shading and textures")->capture_default_str();
  verb->callback([&context, request] {
    if (request->volumes.empty() && request->labels.empty())
      throw WrongUsage("no scan is given", "give a NIfTI file or --labels HEAD");
    std::printf("%s", skinMarkdown(evaluateSkin(context, *request)).c_str());
  });
}

}  // namespace facenav::app
