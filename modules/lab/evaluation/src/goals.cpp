#include "facenav/evaluation/goals.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/number_text.h"
#include "facenav/evaluation/error_statistics.h"
#include "goal_parts.h"

namespace facenav::evaluation {
namespace {

GoalRow timeGoal(const std::vector<Measured>& all) {
  std::vector<double> both, head, coil;
  for (const auto& one : all)
    for (const auto& frame : one.run->frames) {
      head.push_back(frame.head_ms);
      coil.push_back(frame.coil_ms);
      both.push_back(frame.head_ms + frame.coil_ms);
    }
  const double median = quantile(both, 0.5), p99 = quantile(both, 0.99);
  return {"processor time a stereo frame, head and coil, one core", "median <= 3 ms, p99 <= 6 ms",
          formatted("median %.2f (head %.2f, coil %.2f), p99 %.2f ms", median, quantile(head, 0.5),
                    quantile(coil, 0.5), p99),
          verdictOf(median <= 3.0 && p99 <= 6.0, !both.empty()), formatted("%zu frames", both.size())};
}

}  // namespace

std::string basis(int runs, std::size_t frames) { return formatted("%d runs, %zu frames", runs, frames); }

Verdict verdictOf(bool is_met, bool is_measured) {
  return !is_measured ? Verdict::not_measured : is_met ? Verdict::met : Verdict::missed;
}

Pool pool(const std::vector<Measured>& all, const Scenarios& scenarios,
          std::optional<ErrorAt> FrameErrors::*which,
          const std::function<bool(const RunRecord&, const FrameErrors&)>& takes) {
  Pool result;
  for (const Measured& one : all) {
    if (!scenarios.empty() && !scenarios.count(one.run->scenario)) continue;
    const std::size_t before = result.mm.size();
    for (const FrameErrors& frame : one.frames)
      if (frame.*which && (!takes || takes(*one.run, frame)))
        result.mm.push_back((frame.*which)->mm), result.deg.push_back((frame.*which)->deg);
    result.runs += result.mm.size() > before;
  }
  return result;
}

std::vector<GoalRow> judge(const std::vector<RunRecord>& runs) {
  std::vector<Measured> all;
  for (const auto& run : runs) all.push_back({&run, frameErrors(run)});
  std::vector<GoalRow> rows;
  addAlignmentGoals(all, rows);
  addTrackingGoals(all, rows);
  addCameraGoals(all, rows);
  addLossGoals(all, rows);
  rows.push_back(timeGoal(all));
  return rows;
}

std::string inWords(Verdict verdict) {
  switch (verdict) {
    case Verdict::met:
      return "met";
    case Verdict::missed:
      return "MISSED";
    default:
      return "-";
  }
}

}  // namespace facenav::evaluation
