#include "facenav/links/igtl_client.h"

#include <gtest/gtest.h>

#include <functional>
#include <thread>

#include "facenav/core/error.h"
#include "live/igtl_server.h"

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
  std::this_thread::sleep_for(150ms);  // nothing comes: too old
  EXPECT_FALSE(client.pose("Coil1ToTracker"));
  server.reset();
  EXPECT_TRUE(comesTrue([&] { return !client.isConnected(); }));
  server = std::make_unique<IgtlServer>("igtl", IgtlPlaceToListen{"127.0.0.1", port}, LiveContent());
  EXPECT_TRUE(comesTrue(isSeen));  // connected again
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
