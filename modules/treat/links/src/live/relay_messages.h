#pragma once
// Messages of InVesalius's relay: topics and their data, from a frame, and what a robot says, in words. The
// conventions are those of interop/invesalius_space.h. Nothing here moves a robot: no objective is ever sent.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "facenav/links/live_output.h"

namespace facenav::links {

struct RelayMessage {
  std::string topic;
  nlohmann::json data = nlohmann::json::object();
};
/// The event's body: {"topic", "data"}.
nlohmann::json bodyOf(const RelayMessage& message);

/// Name of the robot in all messages.
constexpr const char* kRelayRobot = "robot_1";

/// Poses of probe (none), head and coil with their visibilities. A lost one is zeros and not visible.
RelayMessage trackerPoses(const LiveFrame& frame);
/// The frame's other messages: coil pose, coil at target, displacement; each only while it is known.
std::vector<RelayMessage> frameMessages(const LiveFrame& frame);
/// Target in the frame Head; nothing without an alignment or a target.
std::optional<Eigen::Isometry3d> headTarget(const LiveFrame& frame);
/// The target where it is now for the tracker; nothing while the head is lost.
std::optional<RelayMessage> setTarget(const LiveFrame& frame);
RelayMessage unsetTarget();
/// Asks the robot's program to connect to the robot at this address.
RelayMessage connectToRobot(const std::string& address);

/// What a robot's message says, in one line; empty for one that is not shown.
std::string robotWords(const nlohmann::json& body);
/// True if the message says that the robot has been connected.
bool saysConnected(const nlohmann::json& body);

}  // namespace facenav::links
