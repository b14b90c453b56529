#include "evaluate/evaluation_plan.h"

#include <algorithm>
#include <cstdio>
#include <map>

#include "facenav/core/error.h"

namespace facenav::app {
namespace {

constexpr const char* kCapture = "capture";
// Range of the seat. At a capture the patient may sit anywhere; during treatment nobody sits turned by 30
// degrees.
constexpr double kCaptureTurn_deg = 30.0, kCaptureShift_mm = 60.0, kSeatTurn_deg = 6.0, kSeatShift_mm = 20.0;
constexpr double kAlignTurn_deg = 12.0, kAlignShift_mm = 30.0;  // to align, the patient looks at the cameras
constexpr int kQuickFrames = 30, kQuickCaptures = 5, kQuickLost = 90, kDriftFrames = 240;

std::vector<std::string> allScenarios() {
  std::vector<std::string> names;
  for (const auto& kind : room::scenarios())
    if (kind.name != kCapture) names.push_back(kind.name);
  return names;
}

bool drifts(const std::string& scenario) { return scenario.rfind("drift", 0) == 0; }

int framesOf(const EvaluationRequest& request, const std::string& scenario) {
  if (request.frames > 0) return request.frames;
  if (!request.is_quick || scenario == "protractor") return 0;
  const bool has_parts = scenario == "lost" || scenario == "free_motion" ||
                         drifts(scenario);  // shorter runs would end before all parts
  return scenario == "still" ? 15 : has_parts ? kQuickLost : kQuickFrames;
}

std::string inWords(const room::RigOptions& rig) {
  char name[96];
  std::snprintf(name, sizeof name, "f %.0f b %.0f toe-in %.0f roll %.0f", rig.focal_px, rig.baseline_mm,
                rig.convergence_deg, rig.roll_deg);
  return name;
}

/// Options with cameras per seed, for alignment runs: of every three, one pair near the face and two random
/// ones.
room::ScenarioOptions onItsOwnRig(room::ScenarioOptions options, std::uint64_t seed) {
  constexpr std::uint64_t kOfThree = 3, kRigs = 5000;  // seeds beyond those of --rigs
  if (!options.rig_name.empty()) return options;
  if (seed % kOfThree == 0)
    options.rig_name = "close";
  else
    options.rig = room::randomRig(kRigs + seed), options.rig_name = "room";
  return options;
}

/// Plans a run. Rig 0 is that of the room or of the scenario; the others are random, with the number as seed.
PlannedRun planned(const EvaluationRequest& request, int rig, const std::string& scenario,
                   std::uint64_t seed) {
  room::ScenarioOptions options = request.room;
  if (rig > 0) options.rig = room::randomRig(std::uint64_t(rig)), options.rig_name = "room";
  if (scenario == room::kPlainAlign) options = onItsOwnRig(options, seed);
  options.name = scenario;
  options.seed = seed;
  const bool is_capture = scenario == kCapture;
  options.frames = is_capture ? 1 : framesOf(request, scenario);
  if (request.is_quick && drifts(scenario)) {  // at the speed of the whole scenario
    const double share = double(options.frames) / kDriftFrames;
    options.drift_deg *= share, options.drift_mm *= share;
  }
  const bool is_to_align = scenario == room::kPlainAlign;
  options.seat_turn_deg = is_capture ? kCaptureTurn_deg : is_to_align ? kAlignTurn_deg : kSeatTurn_deg;
  options.seat_shift_mm = is_capture ? kCaptureShift_mm : is_to_align ? kAlignShift_mm : kSeatShift_mm;
  return {options, inWords(room::resolved(options).rig)};
}

}  // namespace

std::vector<PlannedRun> plannedRuns(const EvaluationRequest& request) {
  const auto known = allScenarios();
  auto scenarios = request.scenarios.empty() ? known : request.scenarios;
  for (const auto& name : scenarios)
    if (name != kCapture && std::find(known.begin(), known.end(), name) == known.end()) {
      std::string names = kCapture;
      for (const auto& other : known) names += ", " + other;
      throw Error("no scenario of this name", name, "one of: " + names);
    }
  const bool has_captures =
      request.scenarios.empty() || std::find(scenarios.begin(), scenarios.end(), kCapture) != scenarios.end();
  scenarios.erase(std::remove(scenarios.begin(), scenarios.end(), kCapture), scenarios.end());
  const int captures = !has_captures      ? 0
                       : request.is_quick ? std::min(request.captures, kQuickCaptures)
                                          : request.captures;
  std::vector<PlannedRun> runs;
  for (int i = 0; i < captures; ++i)  // rigs take turns
    runs.push_back(planned(request, i % request.rigs, kCapture, std::uint64_t(request.first_seed + i)));
  const int seeds = request.is_quick ? 1 : request.seeds;
  for (int rig = 0; rig < request.rigs; ++rig)
    for (int seed = 0; seed < seeds; ++seed)
      for (const auto& scenario : scenarios)
        runs.push_back(planned(request, rig, scenario, std::uint64_t(request.first_seed + seed)));
  return runs;
}

std::string inWords(const EvaluationRequest& request) {
  std::string heads;
  for (const auto& head : request.heads) heads += (heads.empty() ? "" : ", ") + head;
  const auto runs = plannedRuns(request);
  const auto captures =
      std::count_if(runs.begin(), runs.end(), [](const auto& r) { return r.options.name == kCapture; });
  return "Heads: " + heads + "; for each " + std::to_string(captures) + " captures and " +
         std::to_string(std::ptrdiff_t(runs.size()) - captures) + " sequences with " +
         std::to_string(request.rigs) + " rigs, seeds from " + std::to_string(request.first_seed) + ".";
}

}  // namespace facenav::app
