#pragma once
// Instruction: the one next step with the coil, in words, from the patient's point of view. The value that
// exceeds its tolerance most comes first. "The handle side" is the coil's -y; "the left wing" is the coil's
// left half for a person behind the handle, its +x; "above the coil" means seen along +z, towards the head.

#include <string>

#include "facenav/guidance/guidance.h"

namespace facenav::guidance {

struct Instruction {
  Action action = Action::none;
  std::string
      words;  // English source: "move 3 mm to the patient's left", "tilt the handle side up 4°", "hold"
};

/// Chooses the next instruction. `previous` is the action of the previous frame (none: no hysteresis).
Instruction instruct(const Target& target, const GuidanceValues& values, const Tolerance& tolerance,
                     Action previous = Action::none, const Hysteresis& hysteresis = {});

/// Describes what is lost: "the face is not seen", "the coil's marker is not seen".
std::string lossInWords(LostReason reason, bool is_head);

}  // namespace facenav::guidance
