#include "facenav/session/live_frame.h"

#include <gtest/gtest.h>

#include <thread>

#include "facenav/session/session.h"
#include "live/igtl_server.h"
#include "session_fakes.h"
#include "support/igtl_client.h"

namespace facenav::session {
namespace {

using testing::LoopbackClient;

const RigidTransform<Camera, Marker> kLiveMarker(Eigen::Quaterniond::Identity(), {20, -60, 550});

RigidTransform<Camera, Head> turned(std::int64_t n) {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(0.01 * double(n), Eigen::Vector3d::UnitY())),
          {double(n), 2, 3}};
}

std::unique_ptr<Navigator> liveNavigator(NavigatorSetup setup, fakes::Head::Pose pose,
                                         std::optional<RigidTransform<Camera, Marker>> marker = kLiveMarker) {
  auto navigator = std::make_unique<Navigator>(setup, std::make_unique<fakes::Head>(std::move(pose)),
                                               std::make_unique<fakes::Coil>(marker));
  if (setup.camera_T_mri_at_reference)
    navigator->setTarget(fakes::targetAt(kLiveMarker.reframe<Camera, Coil>()));
  return navigator;
}

const links::LivePose& poseOf(const links::LiveFrame& frame, const std::string& name) {
  for (const auto& each : frame.poses)
    if (each.name == name) return each;
  throw std::runtime_error("no pose " + name);
}

double error(const links::LiveFrame& frame, const std::string& name, const Eigen::Isometry3d& truth) {
  const auto& each = poseOf(frame, name);
  return each.pose ? (each.pose->matrix() - truth.matrix()).norm() : 1e9;
}

TEST(LiveFrame, HoldsThePosesInTheirFrames) {
  const auto navigator = liveNavigator(fakes::setup(), turned);
  const auto state = navigator->process(fakes::frame(4, 0.1));
  const auto frame = liveFrameOf(state);
  const auto camera_T_mri = turned(4).isometry() * fakes::cameraAtReference().isometry();
  const auto camera_T_coil = kLiveMarker.isometry();
  const auto& target = state.chosen->target;
  EXPECT_LT(error(frame, "SubjectToTracker", turned(4).isometry()), 1e-9);
  EXPECT_LT(error(frame, "Coil1ToTracker", camera_T_coil), 1e-9);
  EXPECT_LT(error(frame, "SubjectToMri", fakes::cameraAtReference().isometry().inverse()), 1e-9);
  EXPECT_LT(error(frame, "CoilToMri", camera_T_mri.inverse() * camera_T_coil), 1e-9);
  EXPECT_LT(error(frame, "CoilToTarget",
                  target.mri_T_target.isometry().inverse() * camera_T_mri.inverse() * camera_T_coil),
            1e-9);
  ASSERT_TRUE(frame.mri_T_target);
  EXPECT_LT((frame.mri_T_target->matrix() - target.mri_T_target.isometry().matrix()).norm(), 1e-9);
  EXPECT_EQ(frame.target, "spot");
  EXPECT_EQ(frame.state, "adjust");
  ASSERT_TRUE(frame.guidance);
  EXPECT_NEAR(frame.guidance->distance_mm, state.guidance.values->distance_mm, 1e-12);
  const std::chrono::duration<double> age = std::chrono::system_clock::now() - frame.utc;
  EXPECT_GE(age.count(), 0);
  EXPECT_LT(age.count(), 5);
}

TEST(LiveFrame, WithoutAnAlignmentThereAreTheTrackersPosesAlone) {
  auto setup = fakes::setup();
  setup.camera_T_mri_at_reference.reset();
  const auto frame = liveFrameOf(liveNavigator(setup, turned)->process(fakes::frame(1, 0)));
  ASSERT_EQ(frame.poses.size(), 2u);
  EXPECT_TRUE(poseOf(frame, "SubjectToTracker").pose);
}

TEST(LiveFrame, ALostHeadLosesWhatNeedsItAndAnOldPoseIsNeverSent) {
  const auto seen_once = [](std::int64_t n) { return n == 0 ? std::optional(turned(0)) : std::nullopt; };
  const auto navigator = liveNavigator(fakes::setup(), seen_once);
  navigator->process(fakes::frame(0, 0));
  const auto frame = liveFrameOf(navigator->process(fakes::frame(1, 0.02)));
  for (const char* name : {"SubjectToTracker", "SubjectToMri", "CoilToMri", "CoilToTarget"}) {
    EXPECT_FALSE(poseOf(frame, name).pose) << name;
    EXPECT_EQ(poseOf(frame, name).status, "OUT_OF_VIEW") << name;
  }
  EXPECT_TRUE(poseOf(frame, "Coil1ToTracker").pose);
  EXPECT_EQ(frame.state, "lost");
  EXPECT_FALSE(frame.guidance);
}

TEST(LiveFrame, AWithheldPoseIsLost) {
  const auto navigator = liveNavigator(fakes::setup(), turned);
  navigator->judgeAlignment(true);
  const auto frame = liveFrameOf(navigator->process(fakes::frame(1, 0)));
  for (const char* name : {"SubjectToTracker", "SubjectToMri", "CoilToMri", "CoilToTarget"})
    EXPECT_FALSE(poseOf(frame, name).pose) << name;
}

/// What a session at 60 frames a second did while clients were connected.
struct ServedSession {
  std::uint64_t dropped = 0, tracked = 0;
  links::LiveReport report;
  std::vector<int> frames_of_readers;
};

/// Serves a session to so many clients that read, and to so many that never do.
ServedSession serveTo(std::size_t readers_wanted, std::size_t sleepers_wanted, int frames) {
  links::IgtlServer server("igtl", {"127.0.0.1", 0}, {});
  std::vector<std::unique_ptr<LoopbackClient>> readers, sleepers;
  while (sleepers.size() < sleepers_wanted) {
    sleepers.push_back(std::make_unique<LoopbackClient>(server.port()));
    sleepers.back()->narrow();
  }
  while (readers.size() < readers_wanted) readers.push_back(std::make_unique<LoopbackClient>(server.port()));
  while (server.report().receivers.size() < readers_wanted + sleepers_wanted)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  ServedSession served;
  Session session(std::make_unique<fakes::Source>(frames, 1.0 / 60), liveNavigator(fakes::setup(), turned),
                  {});
  session.follow([&](const NavigationState& state) {
    ++served.tracked;
    server.publish(std::make_shared<links::LiveFrame>(liveFrameOf(state)));
  });
  session.start();
  std::vector<std::thread> threads;
  served.frames_of_readers.assign(readers_wanted, 0);
  for (std::size_t i = 0; i < readers_wanted; ++i)
    threads.emplace_back([&, i] {
      while (const auto message = readers[i]->next("TRANSFORM", 600))
        served.frames_of_readers[i] += message->device == "CoilToMri";
    });
  while (!session.hasEnded()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  served.dropped = session.latest()->dropped;
  session.stop();
  for (auto& thread : threads) thread.join();
  served.report = server.report();
  return served;
}

TEST(LiveSession, FiveClientsOfWhichOneNeverReadsCostNoFrame) {
  constexpr int kFrames = 300;
  const auto served = serveTo(4, 1, kFrames);
  if (served.dropped > 0) {
    // A busy machine drops frames by itself. Waiting for the client would drop nearly all.
    EXPECT_LE(served.dropped, serveTo(0, 0, kFrames).dropped + kFrames / 5);
  }
  EXPECT_EQ(served.tracked + served.dropped, std::uint64_t(kFrames));
  for (const int frames : served.frames_of_readers) EXPECT_GT(frames, int(served.tracked) / 4);
  EXPECT_LT(served.report.most_waiting, 1000u);  // a part of one message, never a queue
}

TEST(LiveSession, AFaultOfTheSessionTakesThePosesBack) {
  Session session(std::make_unique<fakes::Source>(10, 0.01, 5), liveNavigator(fakes::setup(), turned), {});
  std::vector<links::LiveFrame> frames;
  session.follow([&](const NavigationState& state) { frames.push_back(liveFrameOf(state)); });
  session.start();
  while (!session.hasEnded()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  session.stop();
  ASSERT_FALSE(frames.empty());
  for (const auto& each : frames.back().poses) EXPECT_FALSE(each.pose) << each.name;
}

}  // namespace
}  // namespace facenav::session
