#pragma once
// Script: a scenario played out: the Cast of each frame, of the capture pair, and labels for scenario.json.

#include <memory>

#include "facenav/room/scenario.h"
#include "stage.h"

namespace facenav::room {

/// What the cameras do wrong on purpose.
enum class CameraFault { none, black_left, black_both, frozen, swapped };

struct Moment {
  Cast cast;
  CameraFault fault = CameraFault::none;
  std::string label;          // in words: "hold", "approach", "face away" ..
  double later_s = 0.0;       // time that passed without frames until now
  int visit = 0;              // how often the patient has come back
  double right_behind = 0.0;  // the right camera's picture is older by so many frames
};

class Script {
 public:
  virtual ~Script() = default;
  virtual int frameCount() const = 0;
  /// `frame` may lie between two, where a camera is late.
  virtual Moment at(double frame) const = 0;
  /// The head during the capture pair (coil absent).
  virtual Cast capture() const = 0;
};

/// Of a scenario's name. Throws Error for a name that is none of scenarios().
const ScenarioKind& kindOf(const std::string& name);

/// Throws Error for a name that is none of scenarios().
std::unique_ptr<Script> makeScript(const ScenarioOptions& options, const VirtualPatient& patient,
                                   const RigidTransform<Mri, frames::Target>& target,
                                   const RigidTransform<Marker, Coil>& marker_T_coil);

/// The head as it sits before anything moves, facing the middle between the cameras.
RigidTransform<Room, Mri> seatedHead(const ScenarioOptions& options, const VirtualPatient& patient);

}  // namespace facenav::room
