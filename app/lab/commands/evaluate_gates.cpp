// facenav evaluate gates --worlds N --seed S: drawn set-ups, with and without faults, through the steps of
// `facenav track`.

#include <cstdio>
#include <fstream>
#include <iterator>

#include "commands/lab_commands.h"
#include "evaluate/gate_table.h"
#include "evaluate/scratch_folder.h"
#include "evaluate/stranger_pairs.h"
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
  int strangers = 0;
  bool is_even = false, is_odd = false, keeps_pictures = false, uses_kept = false;
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

/// What was measured so far.
struct GateResults {
  std::vector<GateRow> worlds;
  std::vector<StrangerRow> strangers;
};

/// The tables on disk, each line as soon as it is known, and the summary so far.
class GateFiles {
 public:
  GateFiles(const fs::path& folder, bool has_worlds) : folder_(folder) {
    if (folder.empty()) return;
    const fs::path file = folder / "worlds.csv";
    if (fs::exists(folder) && !fs::is_empty(folder) && !fs::exists(file))
      throw Error("exists and is no result of an evaluation of gates", folder.string(),
                  "choose another folder with -o");
    if (!has_worlds && !fs::exists(file))
      throw Error("holds no kept worlds", folder.string(), "run it once with --keep in place of --kept");
    fs::create_directories(folder);
    if (!has_worlds) {
      earlier_ = earlierSummary();
      return;
    }
    stream_.open(file);
    stream_ << gateHeader() << std::flush;
  }
  void addWorld(const GateResults& results) {
    if (folder_.empty()) return;
    stream_ << gateLine(results.worlds.back()) << std::flush;
    write(results);
  }
  void write(const GateResults& results) const {
    if (folder_.empty()) return;
    if (!results.strangers.empty())
      writeWholeFile(folder_ / "strangers.csv", strangerTable(results.strangers));
    writeWholeFile(folder_ / "worlds.md", earlier_ + inWords(results));
  }
  static std::string inWords(const GateResults& results) {
    return gateSummary(results.worlds) +
           (results.strangers.empty() ? "" : strangerSummary(results.strangers));
  }

 private:
  /// The summary of the kept worlds, without that of strangers.
  std::string earlierSummary() const {
    std::ifstream stream(folder_ / "worlds.md");
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    return text.substr(0, text.find(kStrangersHeading));
  }

  fs::path folder_;
  std::string earlier_;
  std::ofstream stream_;
};

/// Runs one trial. A world that cannot be made is left out, with a note.
void addTrial(Context& context, GateHeads& heads, const GatesRequest& request, std::uint64_t seed,
              room::WorldFault fault, GateFiles& files, GateResults& results) {
  const ScratchFolder scratch;
  const bool is_kept = (request.keeps_pictures || request.uses_kept) && !request.output.empty();
  const fs::path kept = request.output / (std::to_string(seed) + "_" + room::nameOf(fault));
  const fs::path folder = is_kept ? kept : scratch.path();
  try {
    if (!request.uses_kept) {
      results.worlds.push_back(runGateTrial(context, heads, seed, fault, folder));
      files.addWorld(results);
    }
    if (request.strangers == 0 || fault != room::WorldFault::none) return;
    const auto pairs =
        pairStrangers(context, heads, room::drawWorld(seed), std::size_t(request.strangers), folder);
    results.strangers.insert(results.strangers.end(), pairs.begin(), pairs.end());
    files.write(results);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& failure) {
    std::fprintf(stderr, "facenav: note: world %llu, %s, is left out: %s\n",
                 static_cast<unsigned long long>(seed), room::nameOf(fault).c_str(), failure.what());
  }
}

void runGates(Context& context, const GatesRequest& request) {
  const auto faults = faultsOf(request.fault);
  GateFiles files(request.output, !request.uses_kept);
  GateHeads heads(context, request.labels);
  const auto seeds = seedsOf(request);
  GateResults results;
  double done = 0;
  for (const auto seed : seeds)
    for (const auto fault : faults) {
      context.monitor.report("world " + std::to_string(seed) + ", " + room::nameOf(fault),
                             done++ / double(seeds.size() * faults.size()));
      addTrial(context, heads, request, seed, fault, files, results);
    }
  if (!context.is_quiet) std::printf("%s", GateFiles::inWords(results).c_str());
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
  auto* strangers =
      verb->add_option(
              "--strangers", request->strangers,
              "also align each world without a fault to the scans of so many other heads, and to the "
              "mirrored one: strangers.csv")
          ->check(CLI::Range(0, 1000))
          ->capture_default_str();
  auto* keep = verb->add_flag("--keep", request->keeps_pictures,
                              "keep each world's recording and case in the output folder");
  auto* output =
      verb->add_option("-o,--output", request->output, "folder for worlds.csv, strangers.csv and worlds.md")
          ->check(folderToMake());
  verb->add_flag("--kept", request->uses_kept,
                 "only --strangers, with the worlds that --keep left in the output folder")
      ->needs(strangers)
      ->needs(output)
      ->excludes(keep);
  verb->callback([&context, request] { runGates(context, *request); });
}

}  // namespace facenav::app
