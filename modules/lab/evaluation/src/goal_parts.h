#pragma once
// Parts shared by the goals of all topics: runs with the errors of their frames, and the parts of a row.

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "facenav/evaluation/frame_errors.h"
#include "facenav/evaluation/goals.h"

namespace facenav::evaluation {

/// Runs with the errors of their frames, computed once.
struct Measured {
  const RunRecord* run;
  std::vector<FrameErrors> frames;
};

/// Formats "12 runs, 480 frames".
std::string basis(int runs, std::size_t frames);
Verdict verdictOf(bool is_met, bool is_measured);

using Scenarios = std::set<std::string>;

/// Errors of one kind, over all frames of some scenarios that `takes` selects.
struct Pool {
  std::vector<double> mm, deg;
  int runs = 0;
};
Pool pool(const std::vector<Measured>& all, const Scenarios& scenarios,
          std::optional<ErrorAt> FrameErrors::*which,
          const std::function<bool(const RunRecord&, const FrameErrors&)>& takes = {});

// Functions that add the rows of one topic each to `rows`.
void addAlignmentGoals(const std::vector<Measured>& all, std::vector<GoalRow>& rows);
void addTrackingGoals(const std::vector<Measured>& all, std::vector<GoalRow>& rows);
void addCameraGoals(const std::vector<Measured>& all,
                    std::vector<GoalRow>& rows);  // cameras with real faults
void addLossGoals(const std::vector<Measured>& all, std::vector<GoalRow>& rows);

}  // namespace facenav::evaluation
