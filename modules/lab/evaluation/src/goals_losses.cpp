#include <algorithm>
#include <cmath>

#include "facenav/core/number_text.h"
#include "facenav/evaluation/error_statistics.h"
#include "goal_parts.h"

namespace facenav::evaluation {
namespace {

GoalRow wrongGoal(const std::vector<Measured>& all) {
  std::size_t head = 0, coil = 0, frames = 0;
  int runs = 0;
  for (const auto& one : all) {
    runs += !one.frames.empty();
    frames += one.frames.size();
    for (const auto& frame : one.frames) head += frame.is_head_wrong, coil += frame.is_coil_wrong;
  }
  return {"wrong poses shown as tracked (> 3 mm or > 2 deg), all scenarios", "0",
          formatted("head %zu, coil %zu", head, coil), verdictOf(head + coil == 0, frames > 0),
          basis(runs, frames)};
}

GoalRow foundAgainGoal(const std::vector<Measured>& all) {
  std::vector<double> times_s;
  int runs = 0;
  for (const auto& one : all) {
    const auto of_run = timesToFindAgain_s(*one.run);
    runs += !of_run.empty();
    times_s.insert(times_s.end(), of_run.begin(), of_run.end());
  }
  const auto s = summarise(times_s);
  return {"found again after a loss", "<= 0.2 s", formatted("median %.3f, max %.3f s", s.median, s.max),
          verdictOf(s.max <= 0.2, s.count > 0), formatted("%d losses in %d runs", s.count, runs)};
}

GoalRow returnsGoal(const char* quantity, const std::vector<Measured>& all, const Scenarios& scenarios) {
  constexpr double kAtOnce_s = 0.2;
  int returns = 0, found = 0, runs = 0;
  for (const auto& one : all) {
    if (!scenarios.count(one.run->scenario)) continue;
    ++runs;
    for (const double waited_s : timesToFindAgain_s(*one.run)) ++returns, found += waited_s <= kAtOnce_s;
  }
  return {quantity, ">= 95 %", formatted("%d of %d", found, returns),
          verdictOf(found >= 0.95 * returns, returns > 0), formatted("%d runs", runs)};
}

/// Counts frames with a head pose, among the frames of some scenarios that `counts` selects.
GoalRow neverShownGoal(const char* quantity, const std::vector<Measured>& all, const Scenarios& scenarios,
                       const std::function<bool(const FrameTruth&)>& counts) {
  std::size_t frames = 0, shown = 0;
  int runs = 0;
  for (const auto& one : all) {
    if (!scenarios.count(one.run->scenario)) continue;
    ++runs;
    for (const auto& frame : one.run->frames)
      if (counts(frame.truth)) ++frames, shown += frame.head_motion.has_value();
  }
  return {quantity, "0", formatted("%zu of %zu frames", shown, frames), verdictOf(shown == 0, frames > 0),
          basis(runs, frames)};
}

}  // namespace

void addLossGoals(const std::vector<Measured>& all, std::vector<GoalRow>& rows) {
  rows.push_back(wrongGoal(all));
  rows.push_back(foundAgainGoal(all));
  rows.push_back(
      returnsGoal("back with another grimace: found within 0.2 s", all, {"grimace", "grimace_other"}));
  rows.push_back(
      returnsGoal("back as a real face shows itself: found within 0.2 s", all, {"moments", "moments_other"}));
  rows.push_back(neverShownGoal("another person shown as the patient", all,
                                {"other_face", "grimace_other", "moments_other"},
                                [](const FrameTruth& truth) { return !truth.head; }));
  rows.push_back(neverShownGoal("a pose shown while the cameras are out of step", all, {"out_of_step"},
                                [](const FrameTruth& truth) { return truth.must_be_lost; }));
}

}  // namespace facenav::evaluation
