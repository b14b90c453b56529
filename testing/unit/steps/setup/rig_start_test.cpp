// A kept rig is verified when its cameras open: adjustments read back, and the calibration judged by the
// coil's marker and by a face. Marker: rendered. Face: a real person before real cameras.

#include "facenav/setup/rig_start.h"

#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "facenav/setup/cameras_learnt.h"
#include "facenav/setup/verified_cameras.h"
#include "support/setup_room.h"
#include "support/test_data.h"

namespace facenav::steps {
namespace {

using ::testing::HasSubstr;
using testing::RoomShows;
namespace rooms = coil_tracking::testing;

capture::NamedRig keptRig(const cameras::StereoRig& rig, const std::string& state = {}) {
  capture::NamedRig kept;
  kept.name = "bar";
  kept.created_utc = "2026-11-24T10:00:00Z";
  kept.rig = rig;
  if (!state.empty())
    kept.last_check = capture::RigCheckNote{"2020-01-02T08:00:00Z", state, "as it was found"};
  return kept;
}

RigStartMethods markerAlone() { return {nullptr, coil_tracking::makeMarkerCoilTracker()}; }

/// Verdict on a marker at rest before cameras whose right one turned sideways.
RigStart byMarker(double turned_deg, const std::string& earlier = {}) {
  const auto rig = rooms::roomRig();
  const auto room = std::make_shared<testing::SetupRoom>();
  room->shows = RoomShows::marker;
  room->turned_deg = turned_deg;
  testing::SetupRoomSource source(room, rig);
  RigStartCheck check(keptRig(rig, earlier), markerAlone());
  for (int i = 0; i < 40 && !check.isDone(); ++i) check.add(*source.next());
  return check.result();
}

TEST(RigStart, TheMarkerShowsThatItHolds) {
  const auto found = byMarker(0);
  EXPECT_EQ(found.state, health::RigState::holds) << found.words();
  EXPECT_EQ(found.by, RigStart::By::marker);
  EXPECT_FALSE(found.isWithheld());
  EXPECT_THAT(found.words(), HasSubstr("adjustments are as kept; the calibration holds: the coil's marker"));
  EXPECT_THAT(found.words(), HasSubstr("60.00 mm true"));
}

TEST(RigStart, ACameraThatTurnedSidewaysIsWithheld) {
  const auto found = byMarker(0.4);
  EXPECT_EQ(found.state, health::RigState::moved) << found.words();
  EXPECT_TRUE(found.isWithheld());
  EXPECT_THAT(found.words(), HasSubstr("instead of 60.00 mm"));
}

TEST(RigStart, AnEarlierFaultStaysUntilTheMarkerClearsIt) {
  const auto rig = rooms::roomRig();
  RigStartCheck unseen(keptRig(rig, "moved"), markerAlone());
  EXPECT_TRUE(unseen.result().isWithheld());
  EXPECT_EQ(unseen.result().state, health::RigState::unclear);
  EXPECT_THAT(
      unseen.result().words(),
      HasSubstr("the check of 2020-01-02T08:00:00Z found a fault that is not repaired: as it was found"));
  EXPECT_FALSE(byMarker(0, "moved").isWithheld());
  EXPECT_TRUE(byMarker(0.4, "moved").isWithheld());
  for (const char* state : {"holds", "unclear"})
    EXPECT_FALSE(RigStartCheck(keptRig(rig, state), markerAlone()).result().isWithheld()) << state;
  for (const char* state : {"swapped", "other_cameras"})
    EXPECT_TRUE(RigStartCheck(keptRig(rig, state), markerAlone()).result().isWithheld()) << state;
}

TEST(RigStart, WithoutFaceAndMarkerNothingIsClaimed) {
  const auto rig = rooms::roomRig();
  const auto room = std::make_shared<testing::SetupRoom>();
  testing::SetupRoomSource source(room, rig);
  RigStartCheck check(keptRig(rig), {std::make_shared<testing::FixedFace>(std::nullopt),
                                     coil_tracking::makeMarkerCoilTracker()});
  for (int i = 0; i < 40; ++i) check.add(*source.next());
  EXPECT_FALSE(check.isDone());
  EXPECT_EQ(check.result().state, health::RigState::unclear);
  EXPECT_FALSE(check.result().isWithheld());
  EXPECT_THAT(check.result().words(), HasSubstr("both cameras must see the face or the coil's marker"));
}

TEST(RigStart, SaysAdjustmentsThatDiffer) {
  RigStartCheck check(keptRig(rooms::roomRig()), markerAlone());
  check.noteSettings({"right camera, focus: the camera stays on automatic"},
                     {"left camera, exposure: was 20 ms, is 8 ms again"});
  EXPECT_THAT(
      check.result().words(),
      HasSubstr("not as kept: right camera, focus: the camera stays on automatic; set again as kept: left "
                "camera, exposure: was 20 ms"));
  EXPECT_FALSE(check.result().isWithheld());
}

/// A person before three real cameras, at five moments; `mount_deg`: rotation of the calibration's right
/// camera against the real one.
class RigStartFace : public ::testing::Test {
 protected:
  void SetUp() override { FACENAV_NEEDS(folder()); }
  static std::filesystem::path folder() { return testing::sharedData() / "real_faces"; }
  static cameras::StereoFrame pairOf(const std::string& cameras, const std::string& moment, double t_s) {
    const auto read = [&](char camera) {
      return cv::imread((folder() / "person" / (camera + moment + ".jpg")).string(), cv::IMREAD_GRAYSCALE);
    };
    return {read(cameras[0]), read(cameras[1]), 0, {t_s}, 0.0};
  }
  /// Adds the same picture twice: the face does not move.
  static void addAtRest(RigStartCheck& check, cameras::StereoFrame frame) {
    check.add(frame);
    frame.captured.s += 0.033;
    check.add(frame);
  }
  static RigStart found(const std::string& cameras, const Eigen::Vector3d& mount_deg,
                        const std::string& earlier = {}) {
    const auto rig =
        testing::turnedRight(cameras::readRig(folder() / (cameras + "_stereo.yml")), mount_deg * kRadPerDeg);
    RigStartCheck check(keptRig(rig, earlier),
                        {std::make_shared<testing::FixedFace>(cv::Rect(100, 100, 300, 300)), nullptr});
    double t_s = 0;
    for (const char* moment : {"_1", "_418", "_835", "_1252", "_1669"})
      addAtRest(check, pairOf(cameras, moment, t_s += 1.0));
    return check.result();
  }
};

TEST_F(RigStartFace, HoldsAsFarAsAFaceShowsIt) {
  for (const char* cameras : {"lm", "mr"}) {
    const auto start = found(cameras, {0, 0, 0});
    EXPECT_EQ(start.state, health::RigState::holds) << cameras << ": " << start.words();
    EXPECT_EQ(start.by, RigStart::By::face);
    EXPECT_THAT(start.words(), HasSubstr("as far as a face shows it"));
  }
}

TEST_F(RigStartFace, ACameraThatNoddedOrRolledIsWithheld) {
  for (const char* cameras : {"lm", "mr"})
    for (const Eigen::Vector3d& mount_deg : {Eigen::Vector3d(0.25, 0, 0), Eigen::Vector3d(0, 0, 0.5)}) {
      const auto start = found(cameras, mount_deg);
      EXPECT_EQ(start.state, health::RigState::moved) << cameras << ": " << start.words();
      EXPECT_TRUE(start.isWithheld());
      EXPECT_THAT(start.words(), HasSubstr("moved against each other"));
    }
}

TEST_F(RigStartFace, AnotherRigsCalibrationIsNamed) {
  RigStartCheck check(keptRig(cameras::readRig(folder() / "mr_stereo.yml")),
                      {std::make_shared<testing::FixedFace>(cv::Rect(100, 100, 300, 300)), nullptr});
  for (int i = 0; i < 3; ++i) addAtRest(check, pairOf("lm", i == 1 ? "_1669" : "_1", 1.0 + i));
  EXPECT_EQ(check.result().state, health::RigState::other_cameras) << check.result().words();
}

/// A face cannot determine a sideways rotation of a camera.
TEST_F(RigStartFace, DoesNotClearAnEarlierFault) {
  const auto start = found("lm", {0, 0, 0}, "moved");
  EXPECT_EQ(start.state, health::RigState::holds);
  EXPECT_TRUE(start.isWithheld());
  EXPECT_THAT(start.words(), HasSubstr("not repaired"));
}

/// One pair of two moments, such as a head that turns before cameras without a trigger, is outvoted.
TEST_F(RigStartFace, PairsOfTwoMomentsAreNoMovedCamera) {
  RigStartCheck check(keptRig(cameras::readRig(folder() / "lm_stereo.yml")),
                      {std::make_shared<testing::FixedFace>(cv::Rect(100, 100, 300, 300)), nullptr});
  auto torn = pairOf("lm", "_418", 1.0);
  torn.right = pairOf("lm", "_835", 1.0).right;
  addAtRest(check, torn);
  EXPECT_EQ(check.result().state, health::RigState::unclear) << check.result().words();
  for (int i = 0; i < 3; ++i) addAtRest(check, pairOf("lm", i == 1 ? "_1669" : "_1", 2.0 + i));
  EXPECT_EQ(check.result().state, health::RigState::holds) << check.result().words();
}

/// A moving head looks like a moved camera if there is no trigger.
TEST_F(RigStartFace, AFaceThatMovesIsNotMeasured) {
  RigStartCheck check(keptRig(cameras::readRig(folder() / "lm_stereo.yml")),
                      {std::make_shared<testing::FixedFace>(cv::Rect(100, 100, 300, 300)), nullptr});
  const auto pair = pairOf("lm", "_1", 0);
  for (int i = 0; i < 20; ++i) {
    auto frame = pair;
    frame.captured = {0.033 * i};
    const cv::Mat shift = (cv::Mat_<double>(2, 3) << 1, 0, 0, 0, 1, 2.0 * i);
    cv::warpAffine(pair.left, frame.left, shift, pair.left.size());
    check.add(frame);
  }
  EXPECT_EQ(check.result().by, RigStart::By::nothing) << check.result().words();
}

class VerifiedRoom : public ::testing::Test {
 protected:
  std::unique_ptr<VerifiedCameras> open(const std::string& earlier = {}) {
    return std::make_unique<VerifiedCameras>(std::make_unique<testing::SetupRoomSource>(room_, rig_),
                                             RigStartCheck(keptRig(rig_, earlier), markerAlone()),
                                             "repair: facenav-gui --set-up --rig bar",
                                             [this](const RigStart& found) {
                                               const std::lock_guard lock(mutex_);
                                               told_.push_back(found);
                                             });
  }
  /// Plays frames until one is doubted, or not, for a while.
  bool becomes(VerifiedCameras& cameras, bool is_doubted) {
    for (const double until_s = Timestamp::now().s + 60; Timestamp::now().s < until_s;)
      if (!cameras.next()->rig_fault.empty() == is_doubted) return true;
    return false;
  }
  std::vector<RigStart> told() {
    const std::lock_guard lock(mutex_);
    return told_;
  }
  cameras::StereoRig rig_ = rooms::roomRig();
  std::shared_ptr<testing::SetupRoom> room_ = std::make_shared<testing::SetupRoom>();
  std::mutex mutex_;
  std::vector<RigStart> told_;
};

TEST_F(VerifiedRoom, FramesOfMovedCamerasCarryTheirFaultAndWhatToDo) {
  room_->shows = RoomShows::marker;
  room_->turned_deg = 0.4;
  const auto cameras = open();
  EXPECT_TRUE(cameras->next()->rig_fault.empty()) << "unclear never blocks";
  ASSERT_TRUE(becomes(*cameras, true));
  EXPECT_THAT(cameras->next()->rig_fault, HasSubstr("moved against each other"));
  EXPECT_THAT(cameras->next()->rig_fault, HasSubstr("; repair: facenav-gui --set-up --rig bar"));
  EXPECT_FALSE(cameras->next()->left.empty()) << "the pictures can still be shown";
  ASSERT_FALSE(told().empty());
  EXPECT_EQ(told().front().state, health::RigState::moved);
}

TEST_F(VerifiedRoom, AnEarlierFaultIsInForceFromTheFirstFrame) {
  const auto cameras = open("moved");
  EXPECT_THAT(cameras->next()->rig_fault, HasSubstr("not repaired"));
  room_->shows = RoomShows::marker;
  EXPECT_TRUE(becomes(*cameras, false)) << "the marker shows that it holds";
  cameras->settle(5);
  EXPECT_EQ(cameras->standing()->state, health::RigState::holds);
}

TEST_F(VerifiedRoom, UnclearIsSaidOnceAndAnAnswerLater) {
  const auto cameras = open();
  for (const double until_s = Timestamp::now().s + 60; told().empty() && Timestamp::now().s < until_s;)
    EXPECT_TRUE(cameras->next()->rig_fault.empty());
  ASSERT_EQ(told().size(), 1u);
  EXPECT_EQ(told()[0].state, health::RigState::unclear);
  room_->shows = RoomShows::marker;
  for (const double until_s = Timestamp::now().s + 60; told().size() < 2 && Timestamp::now().s < until_s;)
    cameras->next();
  ASSERT_EQ(told().size(), 2u);
  EXPECT_EQ(told()[1].state, health::RigState::holds);
}

TEST(KeepRigStart, LeavesAFaultThatNothingCleared) {
  const testing::TemporaryFolder folder;
  const capture::RigStore store(folder.path());
  store.write(keptRig(rooms::roomRig(), "moved"), Existing::refuse);
  RigStart found;
  found.earlier = store.read("bar").last_check;
  keepRigStart(store, "bar", found);
  EXPECT_EQ(store.read("bar").last_check->utc, "2020-01-02T08:00:00Z");
  found.earlier.reset();
  found.state = health::RigState::holds;
  found.geometry = "the calibration holds";
  keepRigStart(store, "bar", found);
  EXPECT_EQ(store.read("bar").last_check->state, "holds");
  EXPECT_GT(store.read("bar").last_check->utc, "2020-01-02T08:00:00Z");
}

session::NavigationState lastState(double left_us, double right_us) {
  session::NavigationState state;
  state.row_times_s = {1e-6 * left_us, 1e-6 * right_us};
  return state;
}

TEST(CamerasLearnt, RowTimesThatTheRigDoesNotState) {
  auto rig = rooms::roomRig();
  EXPECT_TRUE(learntOf(lastState(0, 0), rig).isEmpty());
  const auto learnt = learntOf(lastState(42, 41), rig);
  ASSERT_TRUE(learnt.row_times_s);
  EXPECT_NEAR((*learnt.row_times_s)[1], 41e-6, 1e-12);
  rig.left.row_time_s = 42e-6, rig.right.row_time_s = 41.2e-6;
  EXPECT_TRUE(learntOf(lastState(42, 41), rig).isEmpty());
  EXPECT_TRUE(learntOf(lastState(42, 20), rig).row_times_s);
}

TEST(CamerasLearnt, OfCamerasThatMovedOnlyThat) {
  const auto rig = rooms::roomRig();
  auto state = lastState(42, 41);
  state.rig_correction = health::CorrectedMotion{0.12};
  EXPECT_THAT(learntOf(state, rig).moved, HasSubstr("moved on its mount since the alignment (0.12 deg)"));
  EXPECT_FALSE(learntOf(state, rig).row_times_s);
  state.rig_correction.reset();
  using monitoring::Withheld;
  state.withheld = Withheld{Withheld::Reason::camera_fault,
                            Withheld::Source::cameras,
                            {health::RigState::moved, "the cameras were moved", ""}};
  EXPECT_EQ(learntOf(state, rig).moved, "the cameras were moved");
  for (const auto other : {health::RigState::away, health::RigState::out_of_step}) {
    state.withheld->rig.state = other;
    EXPECT_TRUE(learntOf(state, rig).isEmpty());
  }
}

TEST(CamerasLearnt, AreKeptWithTheRig) {
  const testing::TemporaryFolder folder;
  const capture::RigStore store(folder.path());
  store.write(keptRig(rooms::roomRig(), "holds"), Existing::refuse);
  CamerasLearnt learnt;
  learnt.row_times_s = {42e-6, 41e-6};
  keepLearnt(store, "bar", learnt);
  EXPECT_NEAR(store.read("bar").rig.left.row_time_s, 42e-6, 1e-12);
  EXPECT_EQ(store.read("bar").last_check->state, "holds");
  learnt = {};
  learnt.moved = "a camera has moved by 0.12 deg";
  keepLearnt(store, "bar", learnt);
  EXPECT_EQ(store.read("bar").last_check->state, "unclear");
  EXPECT_THAT(store.read("bar").last_check->words, HasSubstr("in the last session: a camera has moved"));
  EXPECT_FALSE(RigStartCheck(store.read("bar"), markerAlone()).result().isWithheld());
  store.note("bar", {"2020-01-02T08:00:00Z", "moved", "as it was found"});
  keepLearnt(store, "bar", learnt);
  EXPECT_EQ(store.read("bar").last_check->words, "as it was found") << "the worse stays";
  EXPECT_NO_THROW(keepLearnt(store, "gone", learnt));
}

}  // namespace
}  // namespace facenav::steps
