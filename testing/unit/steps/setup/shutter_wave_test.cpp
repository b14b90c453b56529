// The optional step of the set-up in which a waved coil measures the cameras' rolling shutter, and the use of
// the result in the next session.

#include "facenav/setup/shutter_wave.h"

#include <gmock/gmock.h>

#include "facenav/setup/cameras_learnt.h"
#include "facenav/setup/coil_setup.h"
#include "facenav/setup/verified_cameras.h"
#include "support/setup_room.h"
#include "support/test_data.h"

namespace facenav::steps {
namespace {

using ::testing::HasSubstr;
namespace waving = coil_tracking::testing;

using facenav::testing::kWaveFrame_s;
constexpr double kRow_s = facenav::testing::kWaveRow_s;

coil_tracking::CoilResult seenAt(const Eigen::Vector3d& at_mm, std::array<double, 2> row_times_s = {0, 0}) {
  coil_tracking::CoilPose pose;
  pose.camera_T_marker = RigidTransform<Camera, Marker>(Eigen::Quaterniond::Identity(), at_mm);
  coil_tracking::CoilResult result{Tracked<coil_tracking::CoilPose>(pose, 0.9)};
  result.row_times_s = row_times_s;
  return result;
}

/// Plays frames from `first` on in which the marker moves to and fro with this speed.
int waveFor(ShutterWave& wave, double seconds, double speed_mm_s, std::array<double, 2> row_times_s = {0, 0},
            int first = 0) {
  int i = first;
  for (; (i - first) * kWaveFrame_s < seconds; ++i)
    wave.add(seenAt({i % 2 ? speed_mm_s * kWaveFrame_s : 0.0, 0, 600}, row_times_s), i * kWaveFrame_s);
  return i;
}

TEST(ShutterWave, SaysWhatIsMissing) {
  ShutterWave wave(waving::roomRig());
  wave.add(Lost{LostReason::no_marker}, 0.0);
  EXPECT_THAT(wave.words(), HasSubstr("both cameras see its marker"));
  waveFor(wave, 1.0, 60, {0, 0}, 1);
  EXPECT_THAT(wave.words(), HasSubstr("quicker"));
  EXPECT_THAT(wave.words(), HasSubstr("6 of 15 cm a second"));
  EXPECT_EQ(wave.progress(), 0.0) << "slow motion shows nothing";
  waveFor(wave, 1.0, 300, {0, 0}, 60);
  EXPECT_THAT(wave.words(), HasSubstr("wave on"));
  EXPECT_GT(wave.progress(), 0.1);
  EXPECT_FALSE(wave.isDone());
}

TEST(ShutterWave, EndsWithTheMeasuredTimesOnceTheyHaveSettled) {
  ShutterWave wave(waving::roomRig());
  int i = waveFor(wave, 1.0, 300);
  i = waveFor(wave, 0.5, 300, {kRow_s, kRow_s}, i);
  EXPECT_FALSE(wave.isDone());
  EXPECT_FALSE(wave.rowTimes_s());
  i = waveFor(wave, 0.8, 300, {kRow_s, 0.5 * kRow_s}, i);
  EXPECT_FALSE(wave.isDone()) << "they changed";
  waveFor(wave, 0.4, 300, {kRow_s, 0.5 * kRow_s}, i);
  ASSERT_TRUE(wave.isDone());
  EXPECT_EQ((*wave.rowTimes_s())[1], 0.5 * kRow_s);
  EXPECT_THAT(wave.words(), HasSubstr("20 ms by the left camera, in 10 ms by the right"));
}

TEST(ShutterWave, CamerasThatShowNoDelayNeedNoCorrection) {
  ShutterWave wave(waving::roomRig());
  waveFor(wave, 7.0, 300);
  EXPECT_TRUE(wave.isDone());
  EXPECT_FALSE(wave.rowTimes_s());
  EXPECT_THAT(wave.words(), HasSubstr("need no correction"));
  auto stated = waving::roomRig();
  stated.left.row_time_s = stated.right.row_time_s = kRow_s;
  ShutterWave as_stated(stated);
  waveFor(as_stated, 7.0, 300, {kRow_s, kRow_s});
  EXPECT_FALSE(as_stated.rowTimes_s());
  EXPECT_THAT(as_stated.words(), HasSubstr("as this pair states"));
}

TEST(ShutterWave, AQuickCoilWithoutAPoseYetCountsAndAGapDoesNot) {
  ShutterWave wave(waving::roomRig());
  for (int i = 0; i < 60; ++i) wave.add(Lost{LostReason::camera}, i * kWaveFrame_s);
  const double before = wave.progress();
  EXPECT_GT(before, 0.2);
  wave.add(Lost{LostReason::camera}, 30.0);
  EXPECT_EQ(wave.progress(), before);
}

TEST(ShutterWave, CamerasThatDoNotExposeTogetherAreSaid) {
  ShutterWave wave(waving::roomRig());
  for (int i = 0; i < 240; ++i) wave.add(Lost{LostReason::camera}, i * kWaveFrame_s);
  ASSERT_TRUE(wave.isDone());
  EXPECT_FALSE(wave.rowTimes_s());
  EXPECT_THAT(wave.words(), HasSubstr("do not expose at the same time"));
}

/// Row times that the set-up's last step measured for these cameras.
std::optional<std::array<double, 2>> setUp(const cameras::StereoRig& known) {
  using facenav::testing::wavedFrame;
  CoilSetup setup(known, coil_tracking::defaultCoil(), [] { return coil_tracking::makeMarkerCoilTracker(); });
  setup.add(wavedFrame(known, 0));
  setup.startWave();
  for (int i = 1; i < 240 && !setup.wave()->isDone(); ++i) setup.add(wavedFrame(known, i));
  EXPECT_THAT(setup.words(), HasSubstr("the shutter is known"));
  EXPECT_EQ(setup.progress(), 1.0);
  return setup.wave()->rowTimes_s();
}

TEST(ShutterWave, WhatTheSetUpMeasuresIsWhatTheNextSessionTracksWith) {
  const testing::TemporaryFolder folder;
  const capture::RigStore store(folder.path());
  capture::NamedRig bar;
  bar.name = "bar", bar.created_utc = "2026-11-24T10:00:00Z";
  bar.rig = waving::roomRig();
  store.write(bar, Existing::refuse);
  CamerasLearnt learnt;
  learnt.row_times_s = setUp(bar.rig);
  ASSERT_TRUE(learnt.row_times_s);
  keepLearnt(store, "bar", learnt);

  const auto kept = store.read("bar");
  const auto room = std::make_shared<facenav::testing::SetupRoom>();
  room->shows = facenav::testing::RoomShows::marker;
  VerifiedCameras cameras(std::make_unique<facenav::testing::SetupRoomSource>(room, kept.rig),
                          RigStartCheck(kept, {nullptr, coil_tracking::makeMarkerCoilTracker()}), "repair",
                          [](const RigStart&) {});
  const auto tracker = coil_tracking::makeMarkerCoilTracker();
  tracker->start(cameras.rig(), coil_tracking::defaultCoil());
  const auto first = tracker->track(*cameras.next());
  EXPECT_NEAR(first.row_times_s[0], kRow_s, 0.1 * kRow_s) << "before the coil has moved";
  EXPECT_NEAR(first.row_times_s[1], kRow_s, 0.1 * kRow_s);
}

}  // namespace
}  // namespace facenav::steps
