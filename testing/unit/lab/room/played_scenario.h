#pragma once
// A scenario of the room with the egg patient and a small rig, played to its end.

#include <vector>

#include "egg_patient.h"
#include "facenav/room/synthetic_source.h"

namespace facenav::testing {

/// Options of a scenario with a small rig. `frames`: 0 for the whole scenario.
inline room::ScenarioOptions smallScenario(const char* name, int frames = 0) {
  room::ScenarioOptions options;
  options.name = name;
  options.frames = frames;
  options.rig = smallRig();
  return options;
}

struct Played {
  std::vector<cameras::StereoFrame> frames;
  std::vector<room::GroundTruth> truths;
};

inline Played playedToEnd(const room::ScenarioOptions& options) {
  room::SyntheticSource source(options, eggPatient());
  Played all;
  while (const auto frame = source.next()) {
    all.frames.push_back(*frame);
    all.truths.push_back(source.truth());
  }
  return all;
}

}  // namespace facenav::testing
