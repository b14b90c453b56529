#include "live/igtl_server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <thread>

#include "facenav/core/error.h"
#include "support/igtl_client.h"

namespace facenav::links {
namespace {

using testing::LoopbackClient;
using namespace std::chrono_literals;

Eigen::Isometry3d poseAt(double x_mm) {
  Eigen::Isometry3d pose(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()));
  pose.translation() = Eigen::Vector3d(x_mm, -20, 600);
  return pose;
}

std::shared_ptr<LiveFrame> frameAt(double x_mm, bool is_coil_seen = true) {
  auto frame = std::make_shared<LiveFrame>();
  frame->utc = std::chrono::system_clock::now();
  frame->state = "adjust";
  frame->poses = {{"SubjectToTracker", poseAt(x_mm)}, {"Coil1ToTracker", poseAt(x_mm + 1)}};
  if (!is_coil_seen) frame->poses[1] = {"Coil1ToTracker", std::nullopt, "OUT_OF_VIEW"};
  return frame;
}

/// A server on a free port, to which frames are published until the end.
class IgtlServerTest : public ::testing::Test {
 protected:
  explicit IgtlServerTest(LiveContent content = {}) : server_("igtl", {"127.0.0.1", 0}, std::move(content)) {}
  ~IgtlServerTest() override { quiet(); }
  /// Publishes `frame` a hundred times a second.
  void play(std::shared_ptr<LiveFrame> frame) {
    quiet();
    is_playing_ = true;
    player_ = std::thread([this, frame = std::move(frame)] {
      while (is_playing_) {
        auto now = std::make_shared<LiveFrame>(*frame);
        now->utc = std::chrono::system_clock::now();
        server_.publish(now);
        std::this_thread::sleep_for(10ms);
      }
    });
  }
  void quiet() {
    is_playing_ = false;
    if (player_.joinable()) player_.join();
  }
  bool waitForReceivers(std::size_t count) const {
    for (int i = 0; i < 1000 && server_.report().receivers.size() != count; ++i)
      std::this_thread::sleep_for(5ms);
    return server_.report().receivers.size() == count;
  }

  IgtlServer server_;
  std::atomic<bool> is_playing_{false};
  std::thread player_;
};

TEST_F(IgtlServerTest, AClientThatSaysNothingGetsTransformsWithHeader1) {
  play(frameAt(10));
  LoopbackClient client(server_.port());
  const auto before = igtlStamp(std::chrono::system_clock::now() - 5s);
  for (int i = 0; i < 20; ++i) {
    const auto message = client.next();
    ASSERT_TRUE(message);
    EXPECT_EQ(message->type, "TRANSFORM");
    EXPECT_EQ(message->header_version, 1);
    EXPECT_GT(message->stamp, before);
    const bool is_head = message->device == "SubjectToTracker";
    EXPECT_LT((readTransform(message->content)->matrix() - poseAt(is_head ? 10 : 11).matrix()).norm(), 1e-4);
  }
  ASSERT_TRUE(waitForReceivers(1));
  EXPECT_THAT(server_.report().receivers.front(), ::testing::HasSubstr("header 1"));
}

TEST_F(IgtlServerTest, ALostPoseIsTheIdentityAndWithHeader2IsMarked) {
  play(frameAt(10, false));
  LoopbackClient first(server_.port()), second(server_.port());
  const auto plain = first.nextPose("Coil1ToTracker");
  ASSERT_TRUE(plain);
  EXPECT_TRUE(readTransform(plain->content)->matrix().isIdentity());
  second.ask("GET_STATUS", "", 2);
  ASSERT_TRUE(second.next("STATUS"));
  const auto marked = second.nextPose("Coil1ToTracker");
  ASSERT_TRUE(marked);
  EXPECT_EQ(marked->header_version, 2);
  EXPECT_EQ(marked->value("TransformValid"), "0");
  EXPECT_EQ(marked->value("TransformStatus"), "OUT_OF_VIEW");
  EXPECT_TRUE(readTransform(marked->content)->matrix().isIdentity());
  EXPECT_EQ(second.nextPose("SubjectToTracker")->value("TransformValid"), "1");
  EXPECT_EQ(first.nextPose("SubjectToTracker")->header_version, 1);  // the other client stays as it was
}

TEST_F(IgtlServerTest, AnOldPoseIsTakenBackWhenNoFrameComes) {
  LoopbackClient client(server_.port());
  ASSERT_TRUE(waitForReceivers(1));
  const auto frame = frameAt(10);
  server_.publish(frame);
  const auto seen = client.nextPose("SubjectToTracker");
  ASSERT_TRUE(seen);
  EXPECT_FALSE(readTransform(seen->content)->matrix().isIdentity());
  const auto taken_back = client.nextPose("SubjectToTracker");
  ASSERT_TRUE(taken_back);
  EXPECT_TRUE(readTransform(taken_back->content)->matrix().isIdentity());
  EXPECT_GT(taken_back->stamp, seen->stamp);
}

TEST_F(IgtlServerTest, WhatIsAskedForIsAnswered) {
  play(frameAt(10, false));
  LoopbackClient client(server_.port());
  ASSERT_TRUE(client.next());
  client.ask("GET_TDATA");
  const auto tools = client.next("TDATA");
  ASSERT_TRUE(tools);
  ASSERT_EQ(readTools(tools->content)->size(), 1u);  // the lost coil is not there
  EXPECT_EQ(readTools(tools->content)->front().name, "SubjectToTracker");
  client.ask("GET_QTDATA");
  ASSERT_TRUE(client.next("QTDATA"));
  client.ask("GET_STRING");
  EXPECT_EQ(readString(client.next("STRING")->content)->text, "adjust");
  client.ask("GET_STATUS");
  EXPECT_EQ(readStatus(client.next("STATUS")->content)->code, 1);
  client.ask("GET_TRANS", "SubjectToTracker");
  ASSERT_TRUE(client.nextPose("SubjectToTracker"));
  client.ask("GET_POSITION", "SubjectToTracker");
  EXPECT_NEAR(readPosition(client.next("POSITION")->content)->position_mm.x(), 10, 1e-4);
  for (const char* unknown : {"GET_POSITION", "GET_IMAGE", "GET_NDARRAY"}) {
    client.ask(unknown, "Coil1ToTracker");
    EXPECT_EQ(readStatus(client.next("STATUS")->content)->code, 4) << unknown;
  }
}

TEST_F(IgtlServerTest, AStreamOfToolsStartsAndStops) {
  play(frameAt(10));
  LoopbackClient client(server_.port());
  client.ask("STP_TRANSFORM");  // the header's field holds STP_TRANSFOR
  const auto stopped = client.next("RTS_TRANS");
  ASSERT_TRUE(stopped);
  EXPECT_EQ(readAnswer(stopped->content), 0);
  client.ask("STT_TDATA", "", 1, startContent({20, "Tracker"}));
  EXPECT_EQ(readAnswer(client.next("RTS_TDATA")->content), 0);
  std::uint64_t last = 0;
  for (int i = 0; i < 5; ++i) {
    const auto message = client.next();
    ASSERT_TRUE(message);
    EXPECT_EQ(message->type, "TDATA");
    EXPECT_GT(message->stamp, last);
    last = message->stamp;
  }
  client.ask("STP_TDATA");
  ASSERT_TRUE(client.next("RTS_TDATA"));
  EXPECT_FALSE(client.next({}, 200));
  client.ask("STT_VIDEO");
  EXPECT_EQ(readAnswer(client.next("RTS_VIDEO")->content), 1);
}

TEST_F(IgtlServerTest, AnotherProtocolAndTooManyClientsAreTurnedAway) {
  play(frameAt(10));
  LoopbackClient wrong(server_.port());
  wrong.send(Bytes(200, 'G'));
  EXPECT_TRUE(wrong.isClosed());
  std::vector<std::unique_ptr<LoopbackClient>> clients;
  for (int i = 0; i < 8; ++i) clients.push_back(std::make_unique<LoopbackClient>(server_.port()));
  ASSERT_TRUE(waitForReceivers(8));
  LoopbackClient ninth(server_.port());
  EXPECT_TRUE(ninth.isClosed());
  clients.resize(2);
  EXPECT_TRUE(waitForReceivers(2));
  for (const auto& client : clients) EXPECT_TRUE(client->nextPose("SubjectToTracker"));
}

TEST_F(IgtlServerTest, AFloodOfRequestsDoesNotStopTheOthers) {
  play(frameAt(10));
  LoopbackClient flood(server_.port()), other(server_.port());
  std::atomic<bool> is_flooding{true};
  std::thread flooder([&] {
    while (is_flooding) flood.ask("GET_TDATA");  // never reads the answers
  });
  for (int i = 0; i < 50; ++i) EXPECT_TRUE(other.nextPose("SubjectToTracker"));
  EXPECT_LT(server_.report().most_waiting, 70000u);
  quiet();
  is_flooding = false;
  ::shutdown(flood.socket(), SHUT_RDWR);
  flooder.join();
}

/// A server that can send an image.
class IgtlContentTest : public IgtlServerTest {
 protected:
  static constexpr int kEdge = 128;
  IgtlContentTest()
      : IgtlServerTest([](const std::string& type, const std::string& name) -> std::optional<Bytes> {
          if (type != "IMAGE" || name != "MRI") return std::nullopt;
          IgtlImage image;
          image.size = {kEdge, kEdge, kEdge};
          image.voxels.assign(std::size_t(kEdge) * kEdge * kEdge, 0.5f);
          image.voxels.back() = 7;
          return imageContent(image);
        }) {}
};

TEST_F(IgtlContentTest, AnImageArrivesWholeWhileOthersGetTheirPoses) {
  play(frameAt(10));
  LoopbackClient client(server_.port()), other(server_.port());
  client.ask("GET_IMAGE", "MRI");
  client.ask("GET_POLYDATA", "Scalp");
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(other.nextPose("SubjectToTracker"));
  const auto message = client.next("IMAGE");
  ASSERT_TRUE(message);
  const auto image = readImage(message->content);
  ASSERT_TRUE(image);
  EXPECT_EQ(image->size, (std::array<int, 3>{kEdge, kEdge, kEdge}));
  EXPECT_EQ(image->voxels.back(), 7);
  EXPECT_EQ(readStatus(client.next("STATUS")->content)->text, "POLYDATA Scalp");
  EXPECT_TRUE(client.nextPose("SubjectToTracker"));
}

TEST(IgtlServer, TheLastMessageSaysThatEveryPoseIsLost) {
  auto server = std::make_unique<IgtlServer>("igtl", IgtlPlaceToListen{"127.0.0.1", 0}, LiveContent());
  LoopbackClient client(server->port());
  while (server->report().receivers.empty()) std::this_thread::sleep_for(5ms);
  server->publish(frameAt(10));
  ASSERT_TRUE(client.nextPose("SubjectToTracker"));
  server.reset();
  const auto last = client.nextPose("SubjectToTracker");
  ASSERT_TRUE(last);
  EXPECT_TRUE(readTransform(last->content)->matrix().isIdentity());
  EXPECT_TRUE(client.isClosed());
}

TEST(IgtlServer, APortInUseAndWrongWordsAreRefused) {
  IgtlServer server("igtl", {"127.0.0.1", 0}, {});
  EXPECT_THROW(openLiveOutput("igtl:" + std::to_string(server.port())), Error);
  for (const char* words :
       {"", "igtl:", "igtl:x", "igtl:70000", "osc", "osc:0", "json:h:p:1", "udp:5", "igtl:1 "})
    EXPECT_THROW(requireLiveOutput(words), Error) << words;
  for (const char* words : {"igtl", "igtl:0", "igtl:0.0.0.0:18944", "osc:9000", "json:localhost:9001"})
    EXPECT_NO_THROW(requireLiveOutput(words)) << words;
}

}  // namespace
}  // namespace facenav::links
