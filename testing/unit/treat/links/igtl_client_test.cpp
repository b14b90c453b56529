#include "facenav/links/igtl_client.h"

#include <gtest/gtest.h>

#include <functional>
#include <thread>

#include "facenav/core/error.h"
#include "live/igtl_server.h"
#include "support/igtl_sender.h"

namespace facenav::links {
namespace {

using namespace std::chrono_literals;

bool comesTrue(const std::function<bool()>& condition) {
  for (int i = 0; i < 1000 && !condition(); ++i) std::this_thread::sleep_for(5ms);
  return condition();
}

Eigen::Isometry3d coilPose() {
  Eigen::Isometry3d pose(Eigen::AngleAxisd(0.6, Eigen::Vector3d(1, 1, 0).normalized()));
  pose.translation() = Eigen::Vector3d(5, 6, 700);
  return pose;
}

std::shared_ptr<LiveFrame> coilFrame(std::optional<Eigen::Isometry3d> pose) {
  auto frame = std::make_shared<LiveFrame>();
  frame->utc = std::chrono::system_clock::now();
  frame->poses = {{"Coil1ToTracker", pose, pose ? "OK" : "OUT_OF_VIEW"}};
  return frame;
}

TEST(IgtlClient, ReadsPosesAndLosesThemWithTheServer) {
  auto server = std::make_unique<IgtlServer>("igtl", IgtlPlaceToListen{"127.0.0.1", 0}, LiveContent());
  const int port = server->port();
  const IgtlClient client("127.0.0.1", port);
  ASSERT_TRUE(comesTrue([&] { return client.isConnected(); }));
  const auto isSeen = [&] {
    server->publish(coilFrame(coilPose()));
    return client.pose("Coil1ToTracker").has_value();
  };
  ASSERT_TRUE(comesTrue(isSeen));
  EXPECT_LT((client.pose("Coil1ToTracker")->matrix() - coilPose().matrix()).norm(), 1e-4);
  EXPECT_FALSE(client.pose("SubjectToTracker"));
  server->publish(coilFrame(std::nullopt));  // lost: the identity
  EXPECT_TRUE(comesTrue([&] { return !client.pose("Coil1ToTracker"); }));
  ASSERT_TRUE(comesTrue(isSeen));
  std::this_thread::sleep_for(280ms);  // nothing comes: too old
  EXPECT_FALSE(client.pose("Coil1ToTracker"));
  server.reset();
  EXPECT_TRUE(comesTrue([&] { return !client.isConnected(); }));
  server = std::make_unique<IgtlServer>("igtl", IgtlPlaceToListen{"127.0.0.1", port}, LiveContent());
  EXPECT_TRUE(comesTrue(isSeen));  // connected again
}

/// A client and the tracker that it reads.
class ReadTracker : public ::testing::Test {
 protected:
  ReadTracker() { tracker_.isConnected(); }
  /// Sends one pose and returns how the client reads it.
  IgtlReading after(const Eigen::Isometry3d& pose, std::vector<IgtlEntry> metadata = {}) {
    const std::string name = "Tool" + std::to_string(++sent_);
    tracker_.sendPose(name, pose, 0, std::move(metadata));
    return wait(name);
  }
  IgtlReading wait(const std::string& name) const {
    const auto has_come = [&] {
      return client_.read({name}).front().fault.find("has sent no pose") == std::string::npos;
    };
    EXPECT_TRUE(comesTrue([&] { return client_.isConnected() && has_come(); }));
    return client_.read({name}).front();
  }
  static Eigen::Isometry3d with(const Eigen::Matrix3d& matrix) {
    Eigen::Isometry3d pose = coilPose();
    pose.linear() = pose.linear() * matrix;
    return pose;
  }

  testing::IgtlSender tracker_;
  IgtlClient client_{"127.0.0.1", tracker_.port()};
  int sent_ = 0;
};

TEST_F(ReadTracker, AMatrixThatIsNoPoseIsRefusedInWords) {
  EXPECT_TRUE(after(coilPose()).pose);
  Eigen::Matrix3d sheared = Eigen::Matrix3d::Identity();
  sheared(0, 1) = 0.2;
  EXPECT_EQ(after(with(Eigen::Vector3d(1, 1, -1).asDiagonal())).fault, "is mirrored");
  EXPECT_EQ(after(with(1e-3 * Eigen::Matrix3d::Identity())).fault,
            "is scaled by 0.001 (a rotation and millimetres are expected)");
  EXPECT_EQ(after(with(sheared)).fault, "is sheared");
  EXPECT_FALSE(after(with(Eigen::Vector3d(1, 1, -1).asDiagonal())).pose);
  EXPECT_TRUE(after(with(1.001 * Eigen::Matrix3d::Identity())).pose) << "rounding";
}

TEST_F(ReadTracker, WhatTheTrackerCallsLostIsLost) {
  EXPECT_FALSE(after(Eigen::Isometry3d::Identity()).pose);
  EXPECT_FALSE(after(Eigen::Isometry3d::Identity(), {{"TransformValid", "1"}}).pose);
  EXPECT_FALSE(after(coilPose(), {{"TransformValid", "0"}}).pose);
  EXPECT_FALSE(after(coilPose(), {{"TransformValid", "1"}, {"TransformStatus", "OUT_OF_VOLUME"}}).pose);
  EXPECT_TRUE(after(coilPose(), {{"TransformValid", "1"}, {"TransformStatus", "OK"}}).pose);
  IgtlMessage tools;
  tools.header_version = 2;
  tools.type = "TDATA";
  tools.stamp = igtlStamp(std::chrono::system_clock::now());
  tools.content =
      toolsContent({{"Seen", coilPose()}, {"Hidden", coilPose()}, {"Origin", Eigen::Isometry3d::Identity()}});
  tools.metadata = {{"SeenStatus", "OK"}, {"HiddenStatus", "MISSING"}};
  tracker_.send(tools);
  EXPECT_TRUE(wait("Seen").pose);
  EXPECT_FALSE(wait("Hidden").pose);
  EXPECT_FALSE(wait("Origin").pose) << "the identity";
  tools.type = "QTDATA";
  IgtlPlacedTool empty{"Empty", placeOf(coilPose())};
  empty.place.rotation = Eigen::Quaterniond(0, 0, 0, 0);
  tools.content = placedToolsContent({empty, {"Placed", placeOf(coilPose())}});
  tracker_.send(tools);
  EXPECT_TRUE(wait("Placed").pose);
  EXPECT_EQ(wait("Empty").fault, "has a quaternion of length 0");
}

TEST_F(ReadTracker, ATrackerThatRepeatsItsLastMessageHasNoNewPose) {
  const auto stamp = igtlStamp(std::chrono::system_clock::now());
  tracker_.sendPose("Stuck", coilPose(), stamp);
  EXPECT_TRUE(wait("Stuck").pose);
  for (int i = 0; i < 30; ++i) {
    tracker_.sendPose("Stuck", coilPose(), stamp);
    std::this_thread::sleep_for(10ms);
  }
  EXPECT_FALSE(client_.pose("Stuck"));
  EXPECT_EQ(client_.read({"Stuck"}).front().fault, "no new message for 0.25 s");
}

TEST_F(ReadTracker, ToolsAreReadOfTheSameMoment) {
  const std::uint64_t first = igtlStamp(std::chrono::system_clock::now()), second = first + (1u << 31);
  Eigen::Isometry3d later = coilPose();
  later.translation().x() += 10;
  tracker_.sendPose("Head", coilPose(), first);
  tracker_.sendPose("Coil", coilPose(), first);
  tracker_.sendPose("Head", later, second);  // the coil's second message has not come yet
  EXPECT_TRUE(comesTrue([&] { return client_.read({"Head"}).front().stamp == second; }));
  auto both = client_.read({"Head", "Coil"});
  EXPECT_EQ(both[0].stamp, first);
  EXPECT_NEAR(both[0].pose->translation().x(), coilPose().translation().x(), 1e-3);
  tracker_.sendPose("Coil", later, second);
  EXPECT_TRUE(comesTrue([&] { return client_.read({"Head", "Coil"})[0].stamp == second; }));
  tracker_.sendPose("Head", Eigen::Isometry3d::Identity(), second + (1u << 31));
  EXPECT_TRUE(comesTrue([&] { return !client_.pose("Head"); }));
  both = client_.read({"Head", "Coil"});
  EXPECT_FALSE(both[0].pose) << "never an earlier pose of a tool that is lost now";
  EXPECT_TRUE(both[1].pose);
}

TEST(IgtlClient, TheWordsNameServerAndPose) {
  const auto served = servedPoseFrom("igtl://plus.local:18945/Coil1ToTracker");
  EXPECT_EQ(served.host, "plus.local");
  EXPECT_EQ(served.port, 18945);
  EXPECT_EQ(served.name, "Coil1ToTracker");
  EXPECT_EQ(servedPoseFrom("igtl://127.0.0.1/A").port, 18944);
  for (const char* words :
       {"", "igtl://", "igtl://h", "igtl://h/", "igtl:///N", "igtl://h:0/N", "igtl://h:x/N", "http://h/N"})
    EXPECT_THROW(servedPoseFrom(words), Error) << words;
  EXPECT_THROW(IgtlClient("no.such.host.invalid", 1), Error);
}

}  // namespace
}  // namespace facenav::links
