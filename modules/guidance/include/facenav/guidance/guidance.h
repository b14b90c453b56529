#pragma once
// Guidance: poses + target -> what to do with the coil (values of FORMATS.md, guidance.csv). Pure functions;
// takes transforms, not tracker types.

#include <optional>
#include <string>

#include "facenav/core/tracked.h"
#include "facenav/guidance/target.h"

namespace facenav::guidance {

enum class State { on_target, adjust, lost };
std::string toString(State state);

struct Tolerance {
  double lateral_mm = 2.0, depth_mm = 3.0, tilt_rad = 0.0873, twist_rad = 0.1745;
};

struct GuidanceValues {
  double distance_mm, lateral_mm, depth_mm;  // depth signed: > 0 the coil is too deep, < 0 it stands off
  double tilt_rad, twist_rad;                // twist signed about the target's z
  double beam_miss_mm;                       // distance from the cortex point to the coil's z line
  Eigen::Vector2d lateral_in_target_mm;  // where the coil lies from the target, along the target's x and y
  Eigen::Vector2d lateral_in_coil_mm;    // where the target lies from the coil, along the coil's x and y
  Eigen::Vector2d tilt_in_coil_rad;      // rotation about the coil's x and y that would align the z axes
};

/// What the instruction asks for; one at a time.
enum class Action { none, hold, move, lift, press, tilt, turn };

/// Keeps words and state from flickering when a value hovers at its limit; the previous state decides.
struct Hysteresis {
  double release = 1.25;  // on target is left only beyond this multiple of a tolerance
  double change = 1.25;   // another action takes over only when it is this much worse than the present one
};

struct GuidanceState {
  State state = State::lost;
  Action action = Action::none;
  std::optional<LostReason> reason;      // when lost
  std::optional<GuidanceValues> values;  // absent when lost: nothing stale can be shown
  double predicted_error_mm = 0.0;
  std::string instruction;  // in words, English source: "move 3 mm to the patient's left", "hold"
};

/// The values of one pose. The twist is that of the swing-twist decomposition: rotation about z that is left
/// after the least rotation that brings z onto z (undetermined, and given as 0, where the coil is upside
/// down).
GuidanceValues evaluate(const Target& target, const RigidTransform<Mri, Coil>& mri_T_coil);

/// State and instruction from both live poses. Lost when either is lost (the head's reason first).
GuidanceState evaluate(const Target& target, const Tracked<RigidTransform<Camera, Mri>>& camera_T_mri,
                       const Tracked<RigidTransform<Camera, Coil>>& camera_T_coil, const Tolerance& tolerance,
                       double predicted_error_mm);
/// The same, steady from frame to frame: `previous` is the state of the frame before.
GuidanceState evaluate(const Target& target, const Tracked<RigidTransform<Camera, Mri>>& camera_T_mri,
                       const Tracked<RigidTransform<Camera, Coil>>& camera_T_coil, const Tolerance& tolerance,
                       double predicted_error_mm, const GuidanceState& previous,
                       const Hysteresis& hysteresis = {});

}  // namespace facenav::guidance
