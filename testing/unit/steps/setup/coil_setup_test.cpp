// The coil's step: poses of the marker are collected automatically, and the coil is calibrated by pivoting.

#include "facenav/setup/coil_setup.h"

#include <gmock/gmock.h>

#include "unit/track/coil_tracking/coil_scene.h"
#include "unit/treat/session/session_fakes.h"

namespace facenav::steps {
namespace {

using Stage = CoilSetup::Stage;
using ::testing::HasSubstr;
namespace scene = coil_tracking::testing;

/// Returns the poses that the test sets.
struct ShownPose {
  std::optional<RigidTransform<Camera, Marker>> pose;
};

class ShownCoil : public coil_tracking::CoilTracker {
 public:
  explicit ShownCoil(std::shared_ptr<ShownPose> shown) : shown_(std::move(shown)) {}
  void start(const cameras::StereoRig&, const coil_tracking::CoilModel&) override {}
  coil_tracking::CoilResult track(const cameras::StereoFrame&, const coil_tracking::CoilContext&) override {
    if (!shown_->pose) return Lost{LostReason::no_marker};
    coil_tracking::CoilPose coil;
    coil.camera_T_marker = *shown_->pose;
    return Tracked<coil_tracking::CoilPose>(coil, 0.9);
  }

 private:
  std::shared_ptr<ShownPose> shown_;
};

class CoilSetupTest : public ::testing::Test {
 protected:
  CoilSetupTest()
      : setup_(coil_tracking::testing::roomRig(), coil_tracking::defaultCoil(),
               [shown = shown_] { return std::make_unique<ShownCoil>(shown); }) {}
  /// Turns the coil about a fixed tip that touches `tip_mm` of the marker's frame, until the stage ends.
  void pivotAbout(const Eigen::Vector3d& tip_mm, double most_turned_rad = 0.5) {
    const Stage stage = setup_.stage();
    const Eigen::Vector3d tip_in_camera_mm(10, 20, 550);
    for (int i = 0; i < 400 && setup_.stage() == stage; ++i) {
      const Eigen::Matrix3d r = expRotation({most_turned_rad * std::sin(0.41 * i),
                                             most_turned_rad * std::cos(0.29 * i), 0.3 * std::sin(0.13 * i)});
      shown_->pose = RigidTransform<Camera, Marker>(Eigen::Quaterniond(r), tip_in_camera_mm - r * tip_mm);
      setup_.add(*session::fakes::frame(i, 0.03 * i));
    }
  }

  std::shared_ptr<ShownPose> shown_ = std::make_shared<ShownPose>();
  CoilSetup setup_;
};

TEST_F(CoilSetupTest, ThreePivotsGiveTheCoil) {
  setup_.add(*session::fakes::frame(0, 0));
  EXPECT_FALSE(setup_.isSeen());
  EXPECT_THAT(setup_.words(), HasSubstr("4x4_50 id 7"));
  setup_.startPivots();
  const Eigen::Vector3d centre(0, 80, 30);
  pivotAbout(centre);
  ASSERT_EQ(setup_.stage(), Stage::handle) << setup_.words();
  pivotAbout(centre + Eigen::Vector3d(0, -90, 0));
  ASSERT_EQ(setup_.stage(), Stage::side) << setup_.words();
  pivotAbout(centre + Eigen::Vector3d(60, 0, 0));
  ASSERT_EQ(setup_.stage(), Stage::done) << setup_.words();
  ASSERT_TRUE(setup_.result());
  EXPECT_LT((setup_.result()->marker_T_coil.translation_mm() - centre).norm(), 1e-3);
  EXPECT_EQ(setup_.result()->method, "pivot");
  EXPECT_THAT(setup_.words(), HasSubstr("the coil is calibrated"));
}

TEST_F(CoilSetupTest, ACoilThatIsHardlyTurnedIsNotCalibrated) {
  setup_.startPivots();
  pivotAbout({0, 80, 30}, 0.06);
  EXPECT_EQ(setup_.stage(), Stage::centre);
  EXPECT_FALSE(setup_.result());
}

TEST_F(CoilSetupTest, ACoilThatStandsStillIsAskedToTurn) {
  setup_.startPivots();
  shown_->pose = RigidTransform<Camera, Marker>(Eigen::Quaterniond::Identity(), {10, 20, 550});
  for (int i = 0; i < 200; ++i) setup_.add(*session::fakes::frame(i, 0.03 * i));
  EXPECT_THAT(setup_.words(), HasSubstr("the coil stands still: turn it by 30 degrees"));
}

TEST_F(CoilSetupTest, TooLittleTurningIsSaid) {
  setup_.startPivots();
  pivotAbout({0, 80, 30}, 0.09);
  EXPECT_EQ(setup_.stage(), Stage::centre);
  EXPECT_THAT(setup_.words(), HasSubstr("hardly turned"));
}

/// The tip slips by 8 mm while the coil is turned.
TEST_F(CoilSetupTest, APointThatSlipsIsSaid) {
  setup_.startPivots();
  const Eigen::Vector3d tip_mm(0, 80, 30);
  for (int i = 0; i < 120; ++i) {
    const Eigen::Matrix3d r =
        expRotation({0.5 * std::sin(0.41 * i), 0.5 * std::cos(0.29 * i), 0.3 * std::sin(0.13 * i)});
    const Eigen::Vector3d wandering_mm(8 * std::sin(0.7 * i), 8 * std::cos(1.1 * i), 0);
    shown_->pose = RigidTransform<Camera, Marker>(Eigen::Quaterniond(r),
                                                  Eigen::Vector3d(10, 20, 550) + wandering_mm - r * tip_mm);
    setup_.add(*session::fakes::frame(i, 0.03 * i));
  }
  EXPECT_EQ(setup_.stage(), Stage::centre);
  EXPECT_THAT(setup_.words(), HasSubstr("the point slips by"));
}

// ---- Rendered prints, found by the marker's own tracker.

class CoilSetupSeen : public ::testing::Test {
 protected:
  static coil_tracking::CoilModel withMarker(int id) {
    auto coil = coil_tracking::defaultCoil();
    coil.markers.front().id = id;
    return coil;
  }
  void show(const std::vector<int>& ids, int frames = 30) {
    std::vector<scene::PlacedPrint> prints;
    for (const int id : ids)
      prints.push_back(
          {scene::arucoPrint(0, id), 60.0, scene::markerPose(580, 20, 40, 10, {id == 7 ? 0.0 : 90.0, 0})});
    const auto picture = scene::renderMarkers(scene::roomRig(), prints, {});
    for (int i = 0; i < frames; ++i) {
      auto frame = picture;
      frame.number = number_;
      frame.captured = {0.1 * double(number_++)};
      setup_.add(frame);
    }
  }
  std::int64_t number_ = 0;
  CoilSetup setup_{scene::roomRig(), coil_tracking::defaultCoil(),
                   [] { return coil_tracking::makeMarkerCoilTracker(); }};
};

TEST_F(CoilSetupSeen, NoCoilAndAnotherCoilAreSaid) {
  show({});
  EXPECT_THAT(setup_.words(), HasSubstr("hold the coil so that both cameras see its marker (4x4_50 id 7)"));
  show({3});
  EXPECT_THAT(setup_.words(), HasSubstr("this is another coil: its marker is 4x4_50 id 3, not 4x4_50 id 7"));
  show({3, 7});
  EXPECT_EQ(setup_.words(), "the marker is recognised");
}

TEST_F(CoilSetupSeen, EachMistakeWithAJigIsSaid) {
  setup_.startJig(withMarker(7));
  show({7});
  EXPECT_THAT(setup_.words(), HasSubstr("the jig carries the same marker as the coil (4x4_50 id 7)"));
  setup_.startJig(withMarker(3));
  show({7});
  EXPECT_THAT(setup_.words(), HasSubstr("the jig's (4x4_50 id 3) is not: put the jig on the coil"));
  EXPECT_FALSE(setup_.isJigSeen());
  show({3});
  EXPECT_THAT(setup_.words(), HasSubstr("the jig's marker is seen, the coil's (4x4_50 id 7) is not"));
  show({5});
  EXPECT_THAT(setup_.words(), HasSubstr("this is another coil: its marker is 4x4_50 id 5"));
  show({3, 7}, 40);
  EXPECT_EQ(setup_.stage(), Stage::done) << setup_.words();
}

}  // namespace
}  // namespace facenav::steps
