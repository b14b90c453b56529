#pragma once
// The accuracy goals and the measured values: met or missed, over which runs and frames. A goal without data
// is "not measured", never met.

#include <string>
#include <vector>

#include "facenav/evaluation/run_record.h"

namespace facenav::evaluation {

enum class Verdict { met, missed, not_measured };

struct GoalRow {
  std::string quantity, goal, measured;
  Verdict verdict = Verdict::not_measured;
  std::string basis;  // "12 runs, 480 frames"
};

std::vector<GoalRow> judge(const std::vector<RunRecord>& runs);
std::string inWords(Verdict verdict);

}  // namespace facenav::evaluation
