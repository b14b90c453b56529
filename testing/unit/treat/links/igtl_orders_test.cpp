#include "live/igtl_orders.h"

#include <gtest/gtest.h>

#include <mutex>
#include <thread>

#include "facenav/core/error.h"
#include "live/igtl_server.h"
#include "support/igtl_client.h"

namespace facenav::links {
namespace {

const LiveIncoming kAll{true, true, {}}, kNothing{};

IgtlMessage messageOf(const std::string& type, const std::string& device, Bytes content) {
  IgtlMessage message;
  message.type = type;
  message.device = device;
  message.content = std::move(content);
  return message;
}

IgtlMessage textOf(const std::string& text) { return messageOf("STRING", "Command", stringContent({text})); }

Eigen::Isometry3d targetPose() {
  Eigen::Isometry3d pose(Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, 0.2, 0).normalized()));
  pose.translation() = Eigen::Vector3d(-37, -21, 70);
  return pose;
}

TEST(IgtlOrders, TheKnownCommandsAreReadAndNoOther) {
  for (const char* word : {"start", "stop", "pulse", " Pulse\n"})
    EXPECT_EQ(ordersIn(textOf(word), kAll).orders.size(), 1u) << word;
  for (const char* word : {"", " ", "fire", "startle", "start now", "stop B", "pulses"}) {
    const auto found = ordersIn(textOf(word), kAll);
    EXPECT_TRUE(found.orders.empty()) << word;
    EXPECT_NE(found.refusal.find("unknown command"), std::string::npos) << word;
  }
  EXPECT_EQ(ordersIn(textOf("pulse coil B"), kAll).orders.front().coil, "coil B");
  EXPECT_TRUE(ordersIn(textOf("pulse"), {false, true, {}}).orders.empty());
  EXPECT_EQ(ordersIn(textOf("pulse"), kNothing).refusal, "commands are not accepted");
}

TEST(IgtlOrders, ACommandHasItsNameInBothLengthsThatAreUsed) {
  const auto long_name = commandContent({7, "stop", "<Command/>"});
  ASSERT_EQ(long_name.size(), 138u + 10u);
  auto found = ordersIn(messageOf("COMMAND", "Slicer", long_name), kAll);
  ASSERT_EQ(found.orders.size(), 1u);
  EXPECT_EQ(found.orders.front().name, "stop");
  EXPECT_EQ(found.id, 7u);
  Bytes short_name(long_name.begin(), long_name.begin() + 24);  // id and 20 bytes of the name
  short_name.insert(short_name.end(), long_name.begin() + 132, long_name.end());
  found = ordersIn(messageOf("COMMAND", "Slicer", short_name), kAll);
  ASSERT_EQ(found.orders.size(), 1u);
  EXPECT_EQ(found.orders.front().name, "stop");
  EXPECT_EQ(ordersIn(messageOf("COMMAND", "", commandContent({1, "Run", "pulse"})), kAll).orders.size(), 1u);
  Bytes cut = long_name;
  cut.pop_back();
  EXPECT_FALSE(readCommand(cut));
  EXPECT_TRUE(ordersIn(messageOf("COMMAND", "", cut), kAll).orders.empty());
}

TEST(IgtlOrders, TargetsAreThoseThatAreNamedSo) {
  const auto pose = transformContent(targetPose());
  const auto found = ordersIn(messageOf("TRANSFORM", "Target_M1", pose), kAll);
  ASSERT_EQ(found.orders.size(), 1u);
  EXPECT_EQ(found.orders.front().name, "Target_M1");
  EXPECT_LT((*found.orders.front().pose - targetPose().matrix()).norm(), 1e-4);
  for (const char* name : {"Target_", "target_M1", "LinearTransform", "CoilToTarget_"})
    EXPECT_FALSE(ordersIn(messageOf("TRANSFORM", name, pose), kAll).is_order) << name;
  IgtlPoint named, other;
  named.name = "Target_A";
  named.position_mm = Eigen::Vector3d(1, 2, 3);
  other.name = "F-1";
  const auto points = pointsContent({named, other});
  const auto of_list = ordersIn(messageOf("POINT", "Fiducials", points), kAll);
  ASSERT_EQ(of_list.orders.size(), 1u);
  EXPECT_EQ(of_list.orders.front().place_mm, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(ordersIn(messageOf("POINT", "Target_List", points), kAll).orders.back().name, "Target_List F-1");
  EXPECT_EQ(ordersIn(messageOf("TRANSFORM", "Target_M1", pose), {true, false, {}}).refusal,
            "targets are not accepted");
}

TEST(IgtlOrders, TheWordsOfTheOptionAreTargetsAndCommands) {
  EXPECT_TRUE(incomingFrom("targets,commands").takes_commands);
  EXPECT_FALSE(incomingFrom("targets").takes_commands);
  for (const char* words : {"", "all", "targets,", "targets;commands"})
    EXPECT_THROW(incomingFrom(words), Error) << words;
}

TEST(IgtlOrders, AServerHandsOverWhatItAcceptsAndSaysWhatItRefuses) {
  std::mutex mutex;
  std::vector<LiveOrder> received;
  const auto receive = [&](const LiveOrder& order) {
    std::lock_guard lock(mutex);
    received.push_back(order);
  };
  IgtlServer closed("igtl", {"127.0.0.1", 0}, {}), open("igtl", {"127.0.0.1", 0}, {}, {true, false, receive});
  testing::LoopbackClient to_closed(closed.port()), to_open(open.port());
  to_closed.send(encoded(textOf("pulse")));
  auto answer = to_closed.next("STATUS");
  ASSERT_TRUE(answer);
  EXPECT_EQ(readStatus(answer->content)->code, int(IgtlStatusCode::disabled));
  to_open.send(encoded(messageOf("TRANSFORM", "Target_M1", transformContent(targetPose()))));
  answer = to_open.next("STATUS");
  ASSERT_TRUE(answer);
  EXPECT_EQ(readStatus(answer->content)->text, "targets are not accepted");
  to_open.send(encoded(messageOf("COMMAND", "Slicer", commandContent({42, "stop", ""}))));
  answer = to_open.next("RTS_COMMAND");
  ASSERT_TRUE(answer);
  EXPECT_EQ(readCommand(answer->content)->id, 42u);
  EXPECT_EQ(readCommand(answer->content)->name, "");
  to_open.send(encoded(messageOf("COMMAND", "Slicer", commandContent({43, "fire", ""}))));
  answer = to_open.next("RTS_COMMAND");
  ASSERT_TRUE(answer);
  EXPECT_NE(readCommand(answer->content)->name.find("unknown command"), std::string::npos);
  std::lock_guard lock(mutex);
  ASSERT_EQ(received.size(), 1u);
  EXPECT_EQ(received.front().name, "stop");
  EXPECT_EQ(received.front().from.rfind("127.0.0.1:", 0), 0u) << "who sent it";
}

}  // namespace
}  // namespace facenav::links
