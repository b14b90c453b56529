#include "facenav/room/scenario.h"

namespace facenav::room {

const std::vector<ScenarioKind>& scenarios() {
  static const std::vector<ScenarioKind> kinds{
      {"capture", "the still pair for the alignment, and one plain frame", 1},
      {"protractor", "head at -12.5 .. 12.5 deg in steps of 2.5 about each axis, as in the paper", 33},
      {"treatment", "natural head motion; the coil is brought to the target and held for the last second",
       150},
      {"still", "nothing moves; only the sensor noise changes", 20},
      {"free_motion", "the head turns by 30 deg, nods and tilts by 15, shifts by 60 mm, up to 100 mm/s", 240},
      {"occlusion", "a hand, then the coil, hides up to 40 % of the face", 150},
      {"talking", "the patient talks and blinks", 150},
      {"lighting", "lamps change by 40 % and move", 150},
      {"glint", "sweat on the skin: hard highlights that wander as the head moves", 120},
      {"mask", "the patient wears a surgical mask, at the capture too", 100},
      {"mask_on", "the mask is put on after the capture", 100},
      {"other_face", "another person's face takes the patient's place, at once and walking in", 150},
      {"coil_sweep", "the coil's marker at 400-900 mm, tilted up to 60 deg", 120},
      {"lost", "face away, head out of view, cameras black, frozen, swapped: each frame labelled", 180},
  };
  return kinds;
}

}  // namespace facenav::room
