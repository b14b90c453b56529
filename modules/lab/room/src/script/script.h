#pragma once
// Script: runs a scenario: the Cast of each frame and of the capture pair, and labels for scenario.json.

#include <memory>

#include "facenav/room/scenario.h"
#include "stage.h"

namespace facenav::room {

/// Simulated camera faults.
enum class CameraFault { none, black_left, black_both, frozen, swapped };

struct Moment {
  Cast cast;
  CameraFault fault = CameraFault::none;
  std::string label;          // in words: "hold", "approach", "face away" ..
  double later_s = 0.0;       // number of returns of the patient so far
  int visit = 0;              // how often the patient has come back
  double right_behind = 0.0;  // age of the right camera's picture, in frames
};

class Script {
 public:
  virtual ~Script() = default;
  virtual int frameCount() const = 0;
  /// Returns the moment; `frame` may be fractional, for a late camera.
  virtual Moment at(double frame) const = 0;
  /// Returns the head during the capture pair (no coil).
  virtual Cast capture() const = 0;
};

/// Finds the kind with this name. Throws Error for a name that is not in scenarios().
const ScenarioKind& kindOf(const std::string& name);

/// Makes the script. `second_target`: that of a second coil, if there is one. Throws Error for a name that is
/// not in scenarios().
std::unique_ptr<Script> makeScript(
    const ScenarioOptions& options, const VirtualPatient& patient,
    const RigidTransform<Mri, frames::Target>& target, const RigidTransform<Marker, Coil>& marker_T_coil,
    const std::optional<RigidTransform<Mri, frames::Target>>& second_target = {});

/// The initial head pose, facing the point midway between the cameras.
RigidTransform<Room, Mri> seatedHead(const ScenarioOptions& options, const VirtualPatient& patient);

}  // namespace facenav::room
