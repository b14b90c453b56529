#include "facenav/room/scenario.h"

#include "script.h"

namespace facenav::room {
namespace {

constexpr int kGrimaceFrames = 78, kReturnsFrames = 154, kCoarseJpeg = 50;
constexpr double kShiningSkin = 0.6;

}  // namespace

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
      {"grimace",
       "the patient comes back four times, each time after 1.4 s, elsewhere (0.5-5 deg, 3-16 mm) and with "
       "another grimace",
       kGrimaceFrames, kCoarseJpeg, kShiningSkin},
      {"grimace_other", "the same, and another person sits there at the second return", kGrimaceFrames,
       kCoarseJpeg, kShiningSkin},
      {"returns",
       "the patient walks out of the pictures three times and comes back in other light, with another "
       "grimace, turned by 5-15 deg",
       kReturnsFrames, kCoarseJpeg, kShiningSkin},
      {"out_of_step",
       "from frame 24 on the right camera's picture is older than the left one's: the head moved by 3-10 mm "
       "in between",
       60, kCoarseJpeg, kShiningSkin},
  };
  return kinds;
}

ScenarioOptions resolved(ScenarioOptions options) {
  const ScenarioKind& kind = kindOf(options.name);
  if (options.jpeg_quality < 0) options.jpeg_quality = kind.jpeg_quality;
  if (options.gloss < 0.0) options.gloss = kind.gloss;
  return options;
}

}  // namespace facenav::room
