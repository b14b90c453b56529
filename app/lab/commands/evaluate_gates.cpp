// facenav evaluate gates --worlds N --seed S: drawn set-ups, with and without faults, through the steps of
// `facenav track`.

#include <cstdio>
#include <fstream>

#include "commands/lab_commands.h"
#include "evaluate/gate_table.h"
#include "evaluate/scratch_folder.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "typed_values.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

namespace fs = std::filesystem;

struct GatesRequest {
  int worlds = 20;
  std::uint64_t seed = 0;
  std::string fault = "none";
  bool is_even = false, is_odd = false, keeps_pictures = false;
  fs::path labels, output;
};

std::vector<room::WorldFault> faultsOf(const std::string& word) {
  if (word == "none") return {room::WorldFault::none};
  std::vector<room::WorldFault> all{room::WorldFault::none};
  std::string names = "none, all";
  for (const auto fault : room::worldFaults()) {
    if (room::nameOf(fault) == word) return {fault};
    all.push_back(fault);
    names += ", " + room::nameOf(fault);
  }
  if (word == "all") return all;
  throw WrongUsage("no fault is called '" + word + "'", "one of: " + names);
}

/// Seeds from the first one on; only even or odd ones where asked.
std::vector<std::uint64_t> seedsOf(const GatesRequest& request) {
  std::vector<std::uint64_t> seeds;
  for (std::uint64_t seed = request.seed; int(seeds.size()) < request.worlds; ++seed)
    if ((!request.is_even || seed % 2 == 0) && (!request.is_odd || seed % 2 == 1)) seeds.push_back(seed);
  return seeds;
}

/// The table on disk, a line as soon as it is known, and the summary so far.
class GateFiles {
 public:
  explicit GateFiles(const fs::path& folder) : folder_(folder) {
    if (folder.empty()) return;
    const fs::path file = folder / "worlds.csv";
    if (fs::exists(folder) && !fs::is_empty(folder) && !fs::exists(file))
      throw Error("exists and is no result of an evaluation of gates", folder.string(),
                  "choose another folder with -o");
    fs::create_directories(folder);
    stream_.open(file);
    stream_ << gateHeader() << std::flush;
  }
  void add(const std::vector<GateRow>& rows) {
    if (folder_.empty()) return;
    stream_ << gateLine(rows.back()) << std::flush;
    writeWholeFile(folder_ / "worlds.md", gateSummary(rows));
  }

 private:
  fs::path folder_;
  std::ofstream stream_;
};

/// Runs one trial. A world that cannot be made is left out, with a note.
void addTrial(Context& context, GateHeads& heads, const GatesRequest& request, std::uint64_t seed,
              room::WorldFault fault, std::vector<GateRow>& rows) {
  const ScratchFolder scratch;
  const bool is_kept = request.keeps_pictures && !request.output.empty();
  const fs::path kept = request.output / (std::to_string(seed) + "_" + room::nameOf(fault));
  try {
    rows.push_back(runGateTrial(context, heads, seed, fault, is_kept ? kept : scratch.path()));
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& failure) {
    std::fprintf(stderr, "facenav: note: world %llu, %s, is left out: %s\n",
                 static_cast<unsigned long long>(seed), room::nameOf(fault).c_str(), failure.what());
  }
}

void runGates(Context& context, const GatesRequest& request) {
  const auto faults = faultsOf(request.fault);
  GateFiles files(request.output);
  GateHeads heads(context, request.labels);
  const auto seeds = seedsOf(request);
  std::vector<GateRow> rows;
  double done = 0;
  for (const auto seed : seeds)
    for (const auto fault : faults) {
      context.monitor.report("world " + std::to_string(seed) + ", " + room::nameOf(fault),
                             done++ / double(seeds.size() * faults.size()));
      const std::size_t before = rows.size();
      addTrial(context, heads, request, seed, fault, rows);
      if (rows.size() > before) files.add(rows);
    }
  if (!context.is_quiet) std::printf("%s", gateSummary(rows).c_str());
}

}  // namespace

void addEvaluateGates(CLI::App& evaluate, Context& context) {
  auto* verb = evaluate.add_subcommand(
      "gates",
      "drawn set-ups (cameras, light, persons, clothes, rooms, dots), with and without faults: what is "
      "accepted, "
      "tracked, withheld and named. Even seeds are for fitting, odd seeds for scoring");
  auto request = std::make_shared<GatesRequest>();
  std::string faults = "none, all";
  for (const auto fault : room::worldFaults()) faults += ", " + room::nameOf(fault);
  verb->add_option("--worlds", request->worlds, "how many")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  verb->add_option("--seed", request->seed, "the first seed")->capture_default_str();
  verb->add_option("--fault", request->fault, "in each world: " + faults)->capture_default_str();
  auto* even = verb->add_flag("--even", request->is_even, "even seeds only: limits may be fitted on these");
  verb->add_flag("--odd", request->is_odd, "odd seeds only: these score, nothing is fitted on them")
      ->excludes(even);
  verb->add_option("--labels", request->labels,
                   "folder of labelled heads (else FACENAV_SHARED_DATA/head_labels)");
  verb->add_flag("--keep", request->keeps_pictures,
                 "keep each world's recording and case in the output folder");
  verb->add_option("-o,--output", request->output, "folder for worlds.csv and worlds.md")
      ->check(folderToMake());
  verb->callback([&context, request] { runGates(context, *request); });
}

}  // namespace facenav::app
