#include "relay_messages.h"

#include <cctype>

#include "facenav/interop/invesalius_space.h"

namespace facenav::links {
namespace {

using Json = nlohmann::json;

constexpr const char *kFrom = "From Neuronavigation: ", *kToRobot = "Neuronavigation to Robot: ",
                     *kOfRobot = "Robot to Neuronavigation: ";
constexpr std::size_t kLongestSaid = 160;

const std::optional<Eigen::Isometry3d>& poseOf(const LiveFrame& frame, const char* name) {
  static const std::optional<Eigen::Isometry3d> none;
  for (const auto& each : frame.poses)
    if (each.name == name) return each.pose;
  return none;
}

/// Data with the robot's name, under both keys that its programs read.
Json forRobot(Json data) {
  data["robot_id"] = data["robot_ID"] = kRelayRobot;
  return data;
}

Json fourRowsOf(const Eigen::Isometry3d& pose) {
  Json rows = Json::array();
  for (int row = 0; row < 4; ++row) {
    rows.push_back(Json::array());
    for (int column = 0; column < 4; ++column) rows.back().push_back(pose.matrix()(row, column));
  }
  return rows;
}

std::string topicOf(const Json& body) {
  const auto topic = body.is_object() ? body.find("topic") : body.end();
  return body.is_object() && topic != body.end() && topic->is_string() ? topic->get<std::string>() : "";
}

/// A value of the data as text, for people: without control characters, and cut.
std::string valueOf(const Json& body, std::initializer_list<const char*> names) {
  const auto data = body.find("data");
  if (data == body.end() || !data->is_object()) return {};
  for (const char* name : names) {
    const auto value = data->find(name);
    if (value == data->end()) continue;
    std::string text = value->is_string() ? value->get<std::string>()
                                          : value->dump(-1, ' ', true, Json::error_handler_t::replace);
    for (char& c : text)
      if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
    if (text.size() > kLongestSaid) {
      text.resize(kLongestSaid);
      while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80) text.pop_back();
      if (!text.empty() && (static_cast<unsigned char>(text.back()) & 0x80)) text.pop_back();
      text += "..";
    }
    return text;
  }
  return {};
}

std::string objectiveWords(const std::string& number) {
  if (number == "0") return "none";
  if (number == "1") return "follows the target";
  return number == "2" ? "moves away from the head" : number;
}

}  // namespace

Json bodyOf(const RelayMessage& message) { return {{"topic", message.topic}, {"data", message.data}}; }

RelayMessage trackerPoses(const LiveFrame& frame) {
  const interop::InvesaliusNumbers none{};
  const auto &head = poseOf(frame, "SubjectToTracker"), &coil = poseOf(frame, "Coil1ToTracker");
  RelayMessage message{std::string(kFrom) + "Update tracker poses"};
  message.data["poses"] = Json::array(
      {none, head ? interop::trackerNumbers(*head) : none, coil ? interop::trackerNumbers(*coil) : none});
  message.data["visibilities"] = Json::array({false, head.has_value(), coil.has_value()});
  return message;
}

std::vector<RelayMessage> frameMessages(const LiveFrame& frame) {
  std::vector<RelayMessage> messages;
  if (const auto& coil = poseOf(frame, "CoilToMri"); coil && frame.image)
    messages.push_back({std::string(kFrom) + "Send coil pose", {{"coord", frame.image->markerOf(*coil)}}});
  if (!frame.mri_T_target) return messages;
  messages.push_back({std::string(kFrom) + "Coil at target", {{"state", frame.state == "on_target"}}});
  if (const auto& offset = poseOf(frame, "CoilToTarget"))
    messages.push_back({std::string(kToRobot) + "Update displacement to target",
                        forRobot({{"displacement", interop::displacementNumbers(*offset)}})});
  return messages;
}

std::optional<Eigen::Isometry3d> headTarget(const LiveFrame& frame) {
  const auto& mri_T_head = poseOf(frame, "SubjectToMri");
  if (!mri_T_head || !frame.mri_T_target) return std::nullopt;
  return mri_T_head->inverse() * *frame.mri_T_target;
}

std::optional<RelayMessage> setTarget(const LiveFrame& frame) {
  const auto& tracker_T_head = poseOf(frame, "SubjectToTracker");
  const auto head_T_target = headTarget(frame);
  if (!tracker_T_head || !head_T_target) return std::nullopt;
  return RelayMessage{std::string(kToRobot) + "Set target",
                      forRobot({{"target", fourRowsOf(*tracker_T_head * *head_T_target)}})};
}

RelayMessage unsetTarget() { return {std::string(kToRobot) + "Unset target", forRobot(Json::object())}; }

RelayMessage connectToRobot(const std::string& address) {
  return {std::string(kToRobot) + "Connect to robot", forRobot({{"robot_IP", address}})};
}

std::string robotWords(const Json& body) {
  const std::string topic = topicOf(body);
  if (topic.rfind(kOfRobot, 0) != 0) return {};
  const std::string kind = topic.substr(std::string(kOfRobot).size());
  if (kind == "Robot connection status") return "robot: " + valueOf(body, {"data", "state", "status"});
  if (kind == "Update robot status") return "robot's status: " + valueOf(body, {"robot_status", "status"});
  if (kind == "Set objective") return "robot's objective: " + objectiveWords(valueOf(body, {"objective"}));
  if (kind != "Update robot warning") return {};
  const std::string warning = valueOf(body, {"robot_warning", "warning"});
  return warning.empty() ? "robot: no warning" : "robot warns: " + warning;
}

bool saysConnected(const Json& body) {
  return topicOf(body) == std::string(kOfRobot) + "Robot connection status" &&
         valueOf(body, {"data", "state", "status"}) == "Connected";
}

}  // namespace facenav::links
