#pragma once
// Guidance: how far the coil is from the target, and what to do next (values of guidance.csv,
// resources/doc/formats.md). Pure functions of transforms, independent of the trackers.

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
  double distance_mm, lateral_mm, depth_mm;  // depth > 0: the coil is too deep; < 0: it is above the scalp
  double tilt_rad, twist_rad;                // twist is signed, about the target's z
  double beam_miss_mm;                       // distance from the cortex point to the coil's z line
  Eigen::Vector2d lateral_in_target_mm;      // the coil relative to the target, in the target's x and y
  Eigen::Vector2d lateral_in_coil_mm;        // the target relative to the coil, in the coil's x and y
  Eigen::Vector2d tilt_in_coil_rad;          // rotation about the coil's x and y that would align the z axes
};

/// Action that the instruction asks for; one at a time.
enum class Action { none, hold, move, lift, press, tilt, turn };

/// Prevents text and state from flickering when a value is close to its limit, by use of the previous state.
struct Hysteresis {
  double release = 1.25;  // "on target" ends above this multiple of a tolerance
  double change = 1.25;   // another action replaces the current one only if it is worse by this factor
};

struct GuidanceState {
  State state = State::lost;
  Action action = Action::none;
  std::optional<LostReason> reason;      // when lost
  std::optional<GuidanceValues> values;  // empty when lost, so that no old value is shown
  double predicted_error_mm = 0.0;
  std::string instruction;  // in words, English source: "move 3 mm to the patient's left", "hold"
};

/// Computes the guidance values of one pose. The twist comes from the swing-twist decomposition: the rotation
/// about z that remains after the smallest rotation that aligns the z axes. It is undetermined, and set to 0,
/// if the coil is upside down.
GuidanceValues evaluate(const Target& target, const RigidTransform<Mri, Coil>& mri_T_coil);

/// Computes state and instruction from both live poses. Lost if either is lost (the head's reason has
/// priority).
GuidanceState evaluate(const Target& target, const Tracked<RigidTransform<Camera, Mri>>& camera_T_mri,
                       const Tracked<RigidTransform<Camera, Coil>>& camera_T_coil, const Tolerance& tolerance,
                       double predicted_error_mm);
/// Computes state and instruction with hysteresis; `previous` is the state of the previous frame.
GuidanceState evaluate(const Target& target, const Tracked<RigidTransform<Camera, Mri>>& camera_T_mri,
                       const Tracked<RigidTransform<Camera, Coil>>& camera_T_coil, const Tolerance& tolerance,
                       double predicted_error_mm, const GuidanceState& previous,
                       const Hysteresis& hysteresis = {});

}  // namespace facenav::guidance
