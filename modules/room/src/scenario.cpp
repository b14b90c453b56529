#include "facenav/room/scenario.h"

namespace facenav::room {

const std::vector<ScenarioKind>& scenarios() {
  static const std::vector<ScenarioKind> kinds{
      {"capture", "the still pair for the alignment, and one plain frame", 1},
      {"protractor", "head at -12.5 .. 12.5 deg in steps of 2.5 about each axis, as in the paper", 33},
      {"treatment", "natural head motion; the coil is brought to the target and held for the last second",
       150},
      {"still", "nothing moves; only the sensor noise changes", 20},
      {"free_motion", "the head sways and turns at up to about 100 mm/s", 150},
      {"occlusion", "a hand, then the coil, hides up to 40 % of the face", 150},
      {"talking", "the patient talks and blinks", 150},
      {"lighting", "lamps change by 40 % and move", 150},
      {"coil_sweep", "the coil's marker at 400-900 mm, tilted up to 60 deg", 120},
      {"lost", "face away, head out of view, cameras black, frozen, swapped: each frame labelled", 180},
  };
  return kinds;
}

}  // namespace facenav::room
