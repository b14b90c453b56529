#pragma once
// LiveOrder: what a client of the OpenIGTLink server sends to this program: a command by COMMAND or STRING, a
// target by TRANSFORM or POINT named Target_*. The server only hands it over; who receives it decides.
// Nothing is handed over unless it was asked for (LiveIncoming).

#include <Eigen/Geometry>
#include <functional>
#include <optional>
#include <string>

#include "facenav/core/timestamp.h"

namespace facenav::links {

struct LiveOrder {
  enum class Kind { command, target };
  Kind kind = Kind::command;
  std::string from;                         // "127.0.0.1:50112"
  std::string name;                         // of a command: "start", "stop", "pulse"; of a target: its name
  std::string coil;                         // "pulse NAME": the coil that gave it; empty: not said
  std::optional<Eigen::Matrix4d> pose;      // of a target: Coil in RAS, as received, not checked
  std::optional<Eigen::Vector3d> place_mm;  // of a target that is a point only, RAS
  Timestamp arrived;
};

/// What the server takes. By default nothing.
struct LiveIncoming {
  bool takes_commands = false, takes_targets = false;
  /// Called on the server's thread; must return at once.
  std::function<void(const LiveOrder&)> receive = {};
};

/// How the name of a target begins that a client sends.
constexpr const char* kTargetPrefix = "Target_";

/// Reads the words of --accept, "targets,commands". Throws Error for others.
LiveIncoming incomingFrom(const std::string& words);

}  // namespace facenav::links
