#include "facenav/session/navigator.h"

#include <gtest/gtest.h>

#include <set>

#include "session_fakes.h"
#include "support/matchers.h"

namespace facenav::session {
namespace {

using ::facenav::testing::PoseNear;

const RigidTransform<Camera, Head> kMoved(Eigen::Quaterniond(Eigen::AngleAxisd(0.2,
                                                                               Eigen::Vector3d::UnitY())),
                                          {5, 6, 7});
const RigidTransform<Camera, Marker> kMarker(Eigen::Quaterniond(Eigen::AngleAxisd(0.7,
                                                                                  Eigen::Vector3d::UnitX())),
                                             {20, -60, 550});

Navigator makeNavigator(const NavigatorSetup& setup, fakes::Head::Pose head, bool has_coil = true) {
  return Navigator(setup, std::make_unique<fakes::Head>(std::move(head)),
                   std::make_unique<fakes::Coil>(has_coil ? std::optional(kMarker) : std::nullopt));
}

TEST(Navigator, AtTheReferenceTheHeadStandsWhereItWasAligned) {
  auto navigator = makeNavigator(fakes::setup(), [](auto) { return RigidTransform<Camera, Head>(); });
  const auto state = navigator.process(fakes::frame(3, 0.05));
  ASSERT_TRUE(state.camera_T_mri);
  EXPECT_THAT(*state.camera_T_mri, PoseNear(fakes::cameraAtReference(), 1e-9, 1e-9));
  EXPECT_EQ(state.frame, 3);
  EXPECT_DOUBLE_EQ(state.captured.s, 0.05);
}

TEST(Navigator, ChainsHeadMotionWithTheAlignment) {
  auto navigator = makeNavigator(fakes::setup(), [](auto) { return kMoved; });
  const auto state = navigator.process(fakes::frame(0, 0));
  const auto expected =
      RigidTransform<Camera, Mri>::fromIsometry(kMoved.isometry() * fakes::cameraAtReference().isometry());
  ASSERT_TRUE(state.camera_T_mri);
  EXPECT_THAT(*state.camera_T_mri, PoseNear(expected, 1e-9, 1e-9));
}

/// Returns a marker whose corners are `off_px` away from the epipolar lines of the calibration.
class CoilSeenByMovedCameras : public fakes::Coil {
 public:
  CoilSeenByMovedCameras(const cameras::StereoRig& rig, double off_px)
      : fakes::Coil(kMarker), rig_(rig), off_px_(off_px) {}
  coil_tracking::CoilResult track(const cameras::StereoFrame& frame,
                                  const coil_tracking::CoilContext& context) override {
    auto result = fakes::Coil::track(frame, context);
    result.observation = observation();
    return result;
  }

 private:
  health::SquareObservation observation() const {
    health::SquareObservation marker;
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector3d p_mm =
          kMarker.isometry() * Eigen::Vector3d(i == 1 || i == 2 ? 30 : -30, i < 2 ? -30 : 30, 0);
      marker.left_px[i] = cameras::project(rig_.left, p_mm);
      marker.right_px[i] =
          cameras::project(rig_.right, rig_.right_T_left.isometry() * p_mm) + Eigen::Vector2d(0, off_px_);
    }
    marker.size_mm = 60;
    marker.print_sigma_mm = 0.1;
    marker.size_sigma_mm = 0.03;
    return marker;
  }

  cameras::StereoRig rig_;
  double off_px_;
};

TEST(Navigator, RefusesEveryPoseWhenTheCamerasHaveMoved) {
  for (const double off_px : {0.0, 1.2}) {
    Navigator navigator(fakes::setup(), std::make_unique<fakes::Head>([](auto) { return kMoved; }),
                        std::make_unique<CoilSeenByMovedCameras>(fakes::rig(), off_px));
    NavigationState state;
    for (int i = 0; i < 12; ++i) state = navigator.process(fakes::frame(i, i / 60.0));
    EXPECT_EQ(state.head.isTracked(), off_px == 0) << off_px;
    EXPECT_EQ(state.camera_T_coil.isTracked(), off_px == 0) << off_px;
    if (off_px == 0) continue;
    EXPECT_EQ(state.head.reason(), LostReason::camera);
    EXPECT_NE(rigFault(state)->words().find("calibrate again"), std::string::npos);
    EXPECT_EQ(lossInWords(state), "CAMERAS MOVED: calibrate them again");
  }
}

/// The watchdog finds the face elsewhere between 2 s and 5 s.
TEST(Navigator, ShowsNoPoseOfAHeadThatHasDrifted) {
  auto navigator = makeNavigator(fakes::setup(), [](auto) { return kMoved; });
  navigator.setWatchdog(std::make_unique<monitoring::DriftWatchdog>(
      [](const cameras::StereoFrame& frame, const auto&) {
        monitoring::DriftFinding finding;
        const double t_s = frame.captured.s;
        finding.verdict = t_s > 2.0 && t_s < 5.0 ? monitoring::DriftFinding::Verdict::drifted
                                                 : monitoring::DriftFinding::Verdict::agrees;
        return finding;
      },
      monitoring::DriftWatchdog::Mode::in_line));
  for (int i = 0; i < 8 * 30; ++i) {
    const auto state = navigator.process(fakes::frame(i, i / 30.0));
    const double t_s = i / 30.0;
    if (t_s < 2.0 || t_s > 6.0) {
      EXPECT_TRUE(state.head && state.camera_T_mri) << t_s;
    } else if (t_s > 4.0 && t_s < 5.0) {
      ASSERT_FALSE(state.head || state.camera_T_mri) << t_s;
      EXPECT_EQ(state.camera_T_mri.reason(), LostReason::high_residual);
      EXPECT_EQ(state.guidance.state, guidance::State::lost);
      EXPECT_EQ(lossWord(state), "drift");
      EXPECT_NE(lossInWords(state).find("DRIFT: the face no longer matches the MRI"), std::string::npos);
    }
  }
}

TEST(NavigationState, SaysWhatALossLooksLike) {
  using head_tracking::LossDetail;
  std::set<std::string> words;
  for (const auto detail : {LossDetail::unknown, LossDetail::not_found, LossDetail::covered,
                            LossDetail::too_far, LossDetail::blurred, LossDetail::one_camera,
                            LossDetail::frozen, LossDetail::no_picture, LossDetail::swapped}) {
    NavigationState state;
    state.head = Lost{LostReason::few_features};
    state.head_detail = detail;
    words.insert(lossInWords(state));
    EXPECT_EQ(lossWord(state), head_tracking::toString(detail));
  }
  EXPECT_EQ(words.size(), 9u);
  EXPECT_EQ(words.count(""), 0u);
}

TEST(NavigationState, NamesAllThatIsLostInWordsAndNotInCodes) {
  NavigationState state;
  state.head = Lost{LostReason::few_features};
  state.head_detail = head_tracking::LossDetail::covered;
  state.coil = Lost{LostReason::no_marker};
  EXPECT_EQ(lossTitles(state), (std::vector<std::string>{"FACE COVERED OR TURNED AWAY", "COIL NOT SEEN"}));
  EXPECT_EQ(lossTitles(blanked(state, LostReason::stale)), std::vector<std::string>{"NO NEW IMAGES"});
}

struct NotedWork {
  int before_coil = -1, left_by_head = -1;
};

class WorkingHead : public fakes::Head {
 public:
  explicit WorkingHead(NotedWork& noted) : fakes::Head([](auto) { return kMoved; }), noted_(noted) {}
  head_tracking::HeadResult track(const cameras::StereoFrame& frame,
                                  const head_tracking::HeadContext& context) override {
    noted_.left_by_head = context.reserved.comparisons;
    auto result = fakes::Head::track(frame, context);
    result.work = {1234};
    return result;
  }

 private:
  NotedWork& noted_;
};

class WaitingCoil : public fakes::Coil {
 public:
  explicit WaitingCoil(NotedWork& noted) : fakes::Coil(std::nullopt), noted_(noted) {}
  coil_tracking::CoilResult track(const cameras::StereoFrame& frame,
                                  const coil_tracking::CoilContext& context) override {
    noted_.before_coil = context.work_before.comparisons;
    auto result = fakes::Coil::track(frame, context);
    result.deferred = {567};
    return result;
  }

 private:
  NotedWork& noted_;
};

TEST(Navigator, HeadAndCoilShareTheWorkOfAFrame) {
  NotedWork noted;
  Navigator navigator(fakes::setup(), std::make_unique<WorkingHead>(noted),
                      std::make_unique<WaitingCoil>(noted));
  navigator.process(fakes::frame(0, 0));
  EXPECT_EQ(noted.left_by_head, 0) << "nothing was deferred yet";
  navigator.process(fakes::frame(1, 0.02));
  EXPECT_EQ(noted.before_coil, 1234);
  EXPECT_EQ(noted.left_by_head, 567);
}

TEST(Navigator, AppliesTheMarkersPlaceOnTheCoil) {
  auto setup = fakes::setup();
  const RigidTransform<Coil, Marker> coil_T_marker(Eigen::Quaterniond::Identity(), {0, 80, -30});
  setup.coil.markers[0].coil_T_marker = coil_T_marker;
  auto navigator = makeNavigator(setup, [](auto) { return kMoved; });
  const auto state = navigator.process(fakes::frame(0, 0));
  ASSERT_TRUE(state.camera_T_coil);
  EXPECT_THAT(*state.camera_T_coil, PoseNear(kMarker * coil_T_marker.inverse(), 1e-9, 1e-9));
}

TEST(Navigator, IsOnTargetWhereTheTargetWasPlannedAndFollowsTheHead) {
  bool has_moved = false;
  auto navigator = makeNavigator(fakes::setup(),
                                 [&](auto) { return has_moved ? kMoved : RigidTransform<Camera, Head>(); });
  navigator.setTarget(fakes::targetAt(kMarker.reframe<Camera, Coil>()));  // marker_T_coil is the identity
  auto state = navigator.process(fakes::frame(0, 0));
  EXPECT_EQ(state.guidance.state, guidance::State::on_target);
  ASSERT_TRUE(state.guidance.values);
  EXPECT_NEAR(state.guidance.values->distance_mm, 0.0, 1e-9);
  has_moved = true;  // the coil does not move with the cameras
  state = navigator.process(fakes::frame(1, 0.02));
  EXPECT_EQ(state.guidance.state, guidance::State::adjust);
}

TEST(Navigator, IsNeverOnTargetWithAnAlignmentThatIsTooUncertain) {
  auto navigator = makeNavigator(fakes::setup(), [](auto) { return RigidTransform<Camera, Head>(); });
  ChosenTarget target = fakes::targetAt(kMarker.reframe<Camera, Coil>());
  target.error_bound_mm = 8.0;
  navigator.setTarget(target);
  const auto state = navigator.process(fakes::frame(0, 0));
  EXPECT_EQ(state.guidance.state, guidance::State::adjust);
  EXPECT_NE(state.guidance.instruction.find("95 % within 8.0 mm"), std::string::npos);
  EXPECT_TRUE(state.guidance.values);
}

TEST(Navigator, GivesNoPoseAndNoGuidanceWhenTheFaceIsLost) {
  auto navigator = makeNavigator(fakes::setup(), [](auto) { return std::nullopt; });
  navigator.setTarget(fakes::targetAt(kMarker.reframe<Camera, Coil>()));
  const auto state = navigator.process(fakes::frame(0, 0));
  EXPECT_FALSE(state.camera_T_mri);
  EXPECT_EQ(state.camera_T_mri.reason(), LostReason::no_face);
  EXPECT_EQ(state.guidance.state, guidance::State::lost);
  EXPECT_FALSE(state.guidance.values);
  EXPECT_NE(state.guidance.instruction.find("FACE"), std::string::npos);
}

TEST(Navigator, WithoutAnAlignmentTheHeadIsTrackedButNotPlaced) {
  auto setup = fakes::setup();
  setup.camera_T_mri_at_reference.reset();
  auto navigator = makeNavigator(setup, [](auto) { return kMoved; });
  navigator.setTarget(fakes::targetAt(kMarker.reframe<Camera, Coil>()));
  const auto state = navigator.process(fakes::frame(0, 0));
  EXPECT_TRUE(state.head);
  EXPECT_FALSE(state.camera_T_mri);
  EXPECT_EQ(state.guidance.state, guidance::State::lost);
}

TEST(Navigator, AFrameOfAnotherSizeIsACameraFault) {
  auto navigator = makeNavigator(fakes::setup(), [](auto) { return kMoved; });
  auto wrong = std::make_shared<cameras::StereoFrame>(*fakes::frame(0, 0));
  wrong->right = cv::Mat(10, 10, CV_8UC1, cv::Scalar(1));
  const auto state = navigator.process(wrong);
  ASSERT_FALSE(state.head);
  EXPECT_EQ(state.head.reason(), LostReason::camera);
  EXPECT_FALSE(state.camera_T_coil);
}

/// State after three seconds of frames, when a check is done.
NavigationState checkedState(Navigator& navigator, std::int64_t& n) {
  NavigationState state;
  for (int i = 0; i < 30; ++i, ++n) state = navigator.process(fakes::frame(n, 0.1 * double(n)));
  return state;
}

TEST(Navigator, AFailedCheckWithholdsTheHeadUntilOnePasses) {
  auto verdict = monitoring::DriftFinding::Verdict::agrees;
  Navigator navigator(fakes::setup(), std::make_unique<fakes::Head>([](std::int64_t) {
                        return std::optional(RigidTransform<Camera, Head>());
                      }),
                      std::make_unique<fakes::Coil>(std::nullopt));
  EXPECT_FALSE(navigator.checkRegistration()) << "no scalp to check against";
  navigator.setCheck(std::make_unique<monitoring::RegistrationCheck>(
      [&](const auto&, const auto&) {
        monitoring::DriftFinding finding;
        finding.verdict = verdict;
        finding.shift_mm = 3.1;
        return finding;
      },
      monitoring::DriftWatchdog::Mode::in_line));
  std::int64_t n = 0;
  ASSERT_TRUE(navigator.checkRegistration(true));
  const auto first = navigator.process(fakes::frame(n++, 0));
  EXPECT_FALSE(first.camera_T_mri) << "withheld until it is checked";
  EXPECT_NE(lossInWords(first).find("REGISTRATION NOT CHECKED"), std::string::npos);
  auto state = checkedState(navigator, n);
  EXPECT_TRUE(state.camera_T_mri);
  ASSERT_TRUE(state.check);
  EXPECT_TRUE(state.check->hasPassed());
  verdict = monitoring::DriftFinding::Verdict::drifted;
  ASSERT_TRUE(navigator.checkRegistration());
  state = checkedState(navigator, n);
  EXPECT_FALSE(state.camera_T_mri);
  EXPECT_NE(lossInWords(state).find("REGISTRATION FAILED: the face is 3.1 mm"), std::string::npos);
  verdict = monitoring::DriftFinding::Verdict::unknown;
  navigator.checkRegistration();
  EXPECT_FALSE(checkedState(navigator, n).camera_T_mri) << "unknown clears nothing";
  verdict = monitoring::DriftFinding::Verdict::agrees;
  navigator.checkRegistration();
  EXPECT_TRUE(checkedState(navigator, n).camera_T_mri);
}

}  // namespace
}  // namespace facenav::session
