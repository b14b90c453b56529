// facenav evaluate return: return error across visits, with the MRI and with the measured face alone.

#include <cstdio>
#include <set>

#include "commands/lab_commands.h"
#include "evaluate/return_run.h"
#include "facenav/core/whole_file.h"
#include "typed_values.h"
#include "wrong_usage.h"

namespace facenav::app {

void addEvaluateReturn(CLI::App& evaluate, Context& context) {
  auto* verb = evaluate.add_subcommand(
      "return",
      "how far a coil on the expert's pose lies from where the expert held it, at later visits of the "
      "virtual "
      "room; with the MRI, and with the face measured at the first visit in its place");
  struct Request {
    std::vector<std::string> heads{"patient"};
    ReturnRequest run;
    std::filesystem::path output = "facenav_returns";
  };
  auto request = std::make_shared<Request>();
  verb->add_option("--head", request->heads,
                   "heads, as 'facenav evaluate --head'; the next one is the other person")
      ->delimiter(',');
  verb->add_option("--seed", request->run.seeds, "seeds of the visits")->delimiter(',');
  verb->add_option("--frames", request->run.frames, "of each visit")
      ->check(CLI::Range(10, 1000))
      ->capture_default_str();
  verb->add_option_function<std::string>(
          "--using",
          [request](const std::string& words) {
            request->run.has_dots = words == "dots", request->run.has_plain = words == "plain";
          },
          "only first visits with a projector (dots), or only those without (plain); default: both")
      ->check(CLI::IsMember({"dots", "plain"}));
  verb->add_option("-o,--output", request->output, "folder for returns.md and returns.csv")
      ->check(folderToMake())
      ->capture_default_str();
  verb->callback([&context, request] {
    requireUnderstood([&] {
      for (const auto& spec : request->heads) requireKnownHead(spec);
    });
    std::filesystem::create_directories(request->output);
    std::vector<EvaluationHead> heads;
    for (const auto& spec : request->heads) heads.push_back(makeEvaluationHead(context, spec));
    std::vector<ReturnRun> runs;
    for (std::size_t i = 0; i < heads.size(); ++i) {
      const EvaluationHead* other = heads.size() > 1 ? &heads[(i + 1) % heads.size()] : nullptr;
      for (auto& run : runReturns(context, heads[i], other, request->run)) runs.push_back(std::move(run));
      writeWholeFile(request->output / "returns.csv", returnsCsv(runs));  // written after each run, in case a
                                                                          // later one fails
    }
    const std::string table = returnsTable(runs);
    writeWholeFile(request->output / "returns.md", table);
    if (!context.is_quiet) std::printf("%s", table.c_str());
  });
}

}  // namespace facenav::app
