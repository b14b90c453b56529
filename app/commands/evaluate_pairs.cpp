// facenav evaluate pairs PERSON.. [--rigs DIR]: recovery and identity check on photographs of real people,
// and one pair of cameras compared with another.

#include <cstdio>

#include "commands/commands.h"
#include "evaluate/person_pairs.h"

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
  verb->add_option("--head-tracker", *method, "method: " + workflow::namesOf(context.registrations.head_trackers))
      ->capture_default_str();
  verb->callback([&context, people, rigs, method] {
    const auto result = evaluatePairs(
        *people, rigs->empty() ? people->front() : *rigs,
        [&] { return context.registrations.head_trackers.create(*method); }, context.monitor);
    std::printf("%s", pairsTable(result).c_str());
  });
}

}  // namespace facenav::app
