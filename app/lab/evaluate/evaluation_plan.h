#pragma once
// The runs of `facenav evaluate`: scenarios x seeds x rigs for each head, and captures for the alignment
// alone. The patient's seat differs in each run.

#include <string>
#include <vector>

#include "facenav/room/scenario.h"

namespace facenav::app {

struct EvaluationRequest {
  std::vector<std::string> scenarios;  // empty: all
  std::vector<std::string> heads{"patient"};
  int seeds = 3, rigs = 1, captures = 20, first_seed = 1;
  int frames = 0;  // of each scenario; 0: its own length
  bool is_quick = false;
  room::ScenarioOptions room;  // noise, blur, gamma, rig ..: common to all runs
};

struct PlannedRun {
  room::ScenarioOptions options;
  std::string rig;  // in words
};

/// Plans the runs of one head. Throws Error for a scenario that does not exist.
std::vector<PlannedRun> plannedRuns(const EvaluationRequest& request);

/// Summary in one line: "9 scenarios x 3 seeds x 1 rig, 20 captures, head: patient".
std::string inWords(const EvaluationRequest& request);

}  // namespace facenav::app
