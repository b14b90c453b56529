#include "live/relay_messages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "facenav/interop/invesalius_space.h"
#include "live/socket_io.h"

namespace facenav::links {
namespace {

using Json = nlohmann::json;

Eigen::Isometry3d at(double x, double y, double z) {
  return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
}

/// Head 600 mm away, coil beside it, target 3 mm from the coil; the MRI is 100 voxels of 1 mm.
LiveFrame wholeFrame() {
  LiveFrame frame;
  const Eigen::Isometry3d quarter(Eigen::AngleAxisd(EIGEN_PI / 2, Eigen::Vector3d::UnitZ()));
  frame.state = "adjust";
  frame.target = "M1";
  frame.mri_T_target = at(50, 60, 80);
  frame.poses = {{"SubjectToTracker", at(10, 20, 600) * quarter},
                 {"Coil1ToTracker", at(1, 2, 500)},
                 {"SubjectToMri", at(0, 0, 5)},
                 {"CoilToMri", at(52, 63, 87)},
                 {"CoilToTarget", at(2, 3, 7)}};
  volume::VoxelGrid grid;
  grid.size = {100, 100, 100};
  frame.image = std::make_shared<interop::InvesaliusSpace>(grid);
  return frame;
}

const Json* dataOf(const std::vector<RelayMessage>& messages, const std::string& topic) {
  for (const auto& each : messages)
    if (each.topic == topic) return &each.data;
  return nullptr;
}

void expectNear(const Json& numbers, const std::vector<double>& truth) {
  ASSERT_EQ(numbers.size(), truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) EXPECT_NEAR(numbers[i].get<double>(), truth[i], 1e-9) << i;
}

TEST(RelayMessages, PosesAreThoseOfProbeHeadAndCoilWithAnglesZYX) {
  const auto message = trackerPoses(wholeFrame());
  EXPECT_EQ(message.topic, "From Neuronavigation: Update tracker poses");
  EXPECT_EQ(message.data["visibilities"], Json({false, true, true}));
  expectNear(message.data["poses"][0], {0, 0, 0, 0, 0, 0});
  expectNear(message.data["poses"][1], {10, 20, 600, 90, 0, 0});
  expectNear(message.data["poses"][2], {1, 2, 500, 0, 0, 0});
}

TEST(RelayMessages, ALostPoseIsNotVisibleAndHasNoPlace) {
  const auto frame = withoutPoses(wholeFrame(), "OUT_OF_VIEW");
  const auto message = trackerPoses(frame);
  EXPECT_EQ(message.data["visibilities"], Json({false, false, false}));
  for (const auto& pose : message.data["poses"]) expectNear(pose, {0, 0, 0, 0, 0, 0});
  const auto others = frameMessages(frame);
  ASSERT_EQ(others.size(), 1u) << "no pose of the coil, no displacement";
  EXPECT_EQ(others[0].topic, "From Neuronavigation: Coil at target");
  EXPECT_EQ(others[0].data["state"], false);
  EXPECT_FALSE(setTarget(frame)) << "the head is lost";
  EXPECT_EQ(trackerPoses(LiveFrame()).data["visibilities"], Json({false, false, false}));
}

TEST(RelayMessages, CoilAndDisplacementAreInInvesaliussSpace) {
  auto frame = wholeFrame();
  frame.state = "on_target";
  const auto messages = frameMessages(frame);
  const Json* coil = dataOf(messages, "From Neuronavigation: Send coil pose");
  ASSERT_TRUE(coil);
  expectNear((*coil)["coord"], {52, 99 - 63, 87, 180, 0, 90});
  EXPECT_EQ((*dataOf(messages, "From Neuronavigation: Coil at target"))["state"], true);
  const Json* offset = dataOf(messages, "Neuronavigation to Robot: Update displacement to target");
  ASSERT_TRUE(offset);
  expectNear((*offset)["displacement"], {3, 2, -7, 0, 0, 0});
  EXPECT_EQ((*offset)["robot_id"], "robot_1");
  frame.image.reset();
  EXPECT_FALSE(dataOf(frameMessages(frame), "From Neuronavigation: Send coil pose"));
}

TEST(RelayMessages, TheTargetIsWhereTheTrackerWouldSeeTheCoil) {
  const auto message = setTarget(wholeFrame());
  ASSERT_TRUE(message);
  EXPECT_EQ(message->topic, "Neuronavigation to Robot: Set target");
  const Json& rows = message->data["target"];  // (50, 60, 75) in Head, turned by 90 degrees about z
  ASSERT_EQ(rows.size(), 4u);
  expectNear(rows[0], {0, -1, 0, 10 - 60});
  expectNear(rows[1], {1, 0, 0, 20 + 50});
  expectNear(rows[2], {0, 0, 1, 600 + 75});
  expectNear(rows[3], {0, 0, 0, 1});
  auto none = wholeFrame();
  none.mri_T_target.reset();
  EXPECT_FALSE(setTarget(none));
  EXPECT_EQ(bodyOf(unsetTarget())["topic"], "Neuronavigation to Robot: Unset target");
  EXPECT_EQ(connectToRobot("192.168.0.9").data["robot_IP"], "192.168.0.9");
}

TEST(RelayMessages, WhatARobotSaysIsOneLine) {
  const auto words = [](const char* kind, const Json& data) {
    return robotWords({{"topic", std::string("Robot to Neuronavigation: ") + kind}, {"data", data}});
  };
  EXPECT_EQ(words("Robot connection status", {{"data", "Connected"}}), "robot: Connected");
  EXPECT_EQ(words("Set objective", {{"objective", 1}}), "robot's objective: follows the target");
  EXPECT_EQ(words("Update robot warning", {{"robot_warning", "too\nfar\x1b[2J"}}),
            "robot warns: too far [2J");
  EXPECT_EQ(words("Update robot warning", {{"robot_warning", ""}}), "robot: no warning");
  EXPECT_EQ(words("Send force sensor data", {{"force_feedback", 3}}), "");
  EXPECT_LT(words("Update robot warning", {{"robot_warning", std::string(5000, 'x')}}).size(), 200u);
  for (const Json& body :
       {Json(), Json(3), Json::array(), Json{{"topic", 4}}, Json{{"topic", "x"}, {"data", 1}}})
    EXPECT_EQ(robotWords(body), "");
  EXPECT_TRUE(saysConnected(
      {{"topic", "Robot to Neuronavigation: Robot connection status"}, {"data", {{"data", "Connected"}}}}));
}

TEST(SocketIo, ReadsThePacketsOfAServer) {
  const auto opened = socketIoPacketFrom(R"(0{"sid":"a","pingInterval":25000,"pingTimeout":20000})");
  EXPECT_EQ(opened.kind, SocketIoKind::opened);
  EXPECT_DOUBLE_EQ(opened.silence_s, 45);
  EXPECT_EQ(socketIoPacketFrom("40{\"sid\":\"b\"}").kind, SocketIoKind::joined);
  EXPECT_EQ(socketIoPacketFrom("44{\"message\":\"no\"}").kind, SocketIoKind::refused);
  EXPECT_EQ(socketIoPacketFrom("2").kind, SocketIoKind::ping);
  EXPECT_EQ(socketIoPacketFrom("41").kind, SocketIoKind::left);
  const auto event = socketIoPacketFrom(R"(4212["to_neuronavigation",{"topic":"t"}])");
  EXPECT_EQ(event.kind, SocketIoKind::event);
  EXPECT_EQ(event.event, "to_neuronavigation");
  EXPECT_EQ(event.body["topic"], "t");
  const std::string deep = "42[\"a\"," + std::string(100000, '[') + std::string(100000, ']') + "]";
  for (const std::string& text :
       {std::string(), std::string("0"), std::string("42"), std::string("42[]"), std::string("42[1]"),
        std::string("42x[\"a\"]"), std::string("451-[\"a\"]"), deep})
    EXPECT_EQ(socketIoPacketFrom(text).kind, SocketIoKind::other) << text.substr(0, 20);
  EXPECT_EQ(socketIoEvent("e", {{"a", 1}}), R"(42["e",{"a":1}])");
}

}  // namespace
}  // namespace facenav::links
