// facenav evaluate pairs PERSON.. [--rigs DIR]: recovery and identity check on photographs of real people,
// and one pair of cameras compared with another.

#include <cstdio>

#include "commands/lab_commands.h"
#include "evaluate/face_to_face.h"
#include "evaluate/person_pairs.h"
#include "typed_values.h"

namespace facenav::app {

void addEvaluatePairs(CLI::App& evaluate, Context& context) {
  auto* verb = evaluate.add_subcommand(
      "pairs",
      "photographs of real people: found again after a loss, known apart, pair of cameras against pair");
  auto people = std::make_shared<std::vector<std::filesystem::path>>();
  auto rigs = std::make_shared<std::filesystem::path>();
  auto method = std::make_shared<std::string>(context.registrations.head_trackers.defaultName());
  verb->add_option("PERSON", *people, "folders of pictures <camera>_<moment>.jpg|png, one a person")
      ->required()
      ->check(CLI::ExistingDirectory);
  verb->add_option("--rigs", *rigs, "folder of <a><b>_stereo.yml (default: the first person's)")
      ->check(CLI::ExistingDirectory);
  verb->add_option("--head-tracker", *method,
                   "method: " + steps::namesOf(context.registrations.head_trackers))
      ->check(namedIn(context.registrations.head_trackers))
      ->capture_default_str();
  auto is_aligned_only = std::make_shared<bool>(false);
  verb->add_flag("--align", *is_aligned_only,
                 "instead: each pair aligned to the face that one measured at another moment, without dots");
  verb->callback([&context, people, rigs, method, is_aligned_only] {
    const auto& folder = rigs->empty() ? people->front() : *rigs;
    if (*is_aligned_only) {
      const auto agreements =
          alignToMeasuredFaces(context, *people, folder, context.registrations.aligners.defaultName());
      std::printf("%s", facesTable(agreements).c_str());
      return;
    }
    const auto result = evaluatePairs(
        *people, folder, [&] { return context.registrations.head_trackers.create(*method); },
        context.monitor);
    std::printf("%s", pairsTable(result).c_str());
  });
}

}  // namespace facenav::app
