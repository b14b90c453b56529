// Both head trackers on a synthetic face with known motion, and what must be lost.

#include <gtest/gtest.h>

#include <map>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "facenav/core/error.h"
#include "facenav/geometry/pose_error.h"
#include "facenav/tracking/head_tracker.h"
#include "support/matchers.h"
#include "support/synthetic_face.h"
#include "support/test_data.h"

namespace facenav {
namespace {

using testing::SyntheticFace;
using testing::SyntheticView;

constexpr double kDegree = M_PI / 180;
const Point<Head> kCortex(0, -60, 690);  // some 90 mm behind the face

/// The detector that the trackers use; asked again about the same picture (every test starts from the same
/// reference), it remembers its answer.
class RememberingDetector : public tracking::FaceDetector {
 public:
  std::optional<tracking::FaceLandmarks> detect(const cv::Mat& grey) const override {
    for (const auto& [picture, answer] : answers_)
      if (picture.size() == grey.size() && cv::norm(picture, grey, cv::NORM_INF) == 0) return answer;
    answers_.emplace_back(grey.clone(), detector_->detect(grey));
    return answers_.back().second;
  }
  std::optional<tracking::FaceLandmarks> detectNear(const cv::Mat& grey,
                                                    const tracking::FaceLandmarks& last) const override {
    return detector_->detectNear(grey, last);
  }
  std::optional<tracking::FaceLandmarks> detectAtRoll(const cv::Mat& grey, double roll_rad) const override {
    return detector_->detectAtRoll(grey, roll_rad);
  }

 private:
  std::unique_ptr<tracking::FaceDetector> detector_ = tracking::makeFaceDetector();
  mutable std::vector<std::pair<cv::Mat, std::optional<tracking::FaceLandmarks>>> answers_;
};

std::shared_ptr<const tracking::FaceDetector> detector() {
  static const auto shared = std::make_shared<const RememberingDetector>();
  return shared;
}

std::unique_ptr<tracking::HeadTracker> make(bool is_model) {
  return is_model ? tracking::makeModelHeadTracker(detector()) : tracking::makeFeatureHeadTracker(detector());
}

Eigen::Isometry3d motionAt(double phase, double yaw_deg) {
  Vector6d xi;
  xi << 0.4 * yaw_deg * kDegree * std::sin(phase), yaw_deg * kDegree * std::sin(phase + 0.3),
      0.3 * yaw_deg * kDegree * std::cos(phase), 20 * std::sin(phase), 10 * std::cos(phase) - 10,
      15 * std::sin(2 * phase);
  return Eigen::Translation3d(0, 0, 640) * expRigid(xi) * Eigen::Translation3d(0, 0, -640);
}

SyntheticView viewAt(int frame, double yaw_deg) {
  SyntheticView view;
  view.motion = motionAt(2 * M_PI * frame / 60.0, yaw_deg);
  view.seed = std::uint64_t(frame) + 1;
  view.time_s = frame / 30.0;
  return view;
}

/// Turned by `yaw_deg` about the neck.
SyntheticView turnedView(int frame, double yaw_deg) {
  SyntheticView view;
  view.motion = Eigen::Translation3d(0, 0, 700) *
                Eigen::AngleAxisd(yaw_deg * kDegree, Eigen::Vector3d::UnitY()) *
                Eigen::Translation3d(0, 0, -700);
  view.seed = std::uint64_t(frame) + 1;
  view.time_s = frame / 30.0;
  return view;
}

SyntheticView stillView(int frame) {
  SyntheticView view;
  view.seed = std::uint64_t(frame) + 1;
  view.time_s = frame / 30.0;
  return view;
}

struct Errors {
  int frames = 0, lost = 0;
  double target_rms_mm = 0, rotation_rms_deg = 0, worst_mm = 0;
};

PoseError errorOf(const tracking::HeadPose& pose, const SyntheticView& view) {
  return poseError(pose.camera_T_head, RigidTransform<Camera, Head>::fromIsometry(view.motion), kCortex);
}

class HeadTrackers : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(SyntheticFace::portraitPath()))
      GTEST_SKIP() << "no portrait (python3-skimage)";
    rig_ = testing::convergingRig();
    static const SyntheticFace shared = SyntheticFace::astronaut();  // its rays are made once
    face_ = &shared;
  }
  void start(tracking::HeadTracker& tracker, bool with_surface) const {
    static std::map<bool, tracking::HeadReference> references;
    if (references.count(with_surface) == 0) {
      SyntheticView view;
      view.seed = 99;
      references[with_surface] = face_->reference(rig_, with_surface, view);
    }
    tracker.start(rig_, references[with_surface]);
  }
  Errors follow(tracking::HeadTracker& tracker, const std::vector<SyntheticView>& views) const {
    Errors errors;
    for (const auto& view : views) {
      ++errors.frames;
      const auto pose = tracker.track(face_->render(rig_, view));
      if (!pose) {
        ++errors.lost;
        continue;
      }
      const auto error = errorOf(*pose, view);
      errors.target_rms_mm += error.at_point_mm * error.at_point_mm;
      errors.rotation_rms_deg += std::pow(error.rotation_rad / kDegree, 2);
      errors.worst_mm = std::max(errors.worst_mm, error.at_point_mm);
    }
    const double n = std::max(1, errors.frames - errors.lost);
    errors.target_rms_mm = std::sqrt(errors.target_rms_mm / n);
    errors.rotation_rms_deg = std::sqrt(errors.rotation_rms_deg / n);
    return errors;
  }
  static std::vector<SyntheticView> sweep(double yaw_deg, int step, int frames = 60) {
    std::vector<SyntheticView> views;
    for (int frame = 0; frame < frames; frame += step) views.push_back(viewAt(frame, yaw_deg));
    return views;
  }

  stereo::StereoRig rig_;
  const SyntheticFace* face_ = nullptr;
};

TEST_F(HeadTrackers, Features7FollowsWithinTwoMillimetresAtTheCortex) {
  const auto tracker = tracking::makeFeatureHeadTracker(detector());
  start(*tracker, false);
  const Errors errors = follow(*tracker, sweep(8, 6));
  EXPECT_EQ(errors.lost, 0);
  EXPECT_LT(errors.target_rms_mm, 2.0);
  EXPECT_LT(errors.rotation_rms_deg, 1.2);
  EXPECT_LT(errors.worst_mm, 3.0);
}

TEST_F(HeadTrackers, ModelFollowsWithinTwoTenthsOfAMillimetreAtTheCortex) {
  const auto tracker = tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  const Errors errors = follow(*tracker, sweep(15, 5));
  EXPECT_EQ(errors.lost, 0);
  EXPECT_LT(errors.target_rms_mm, 0.2);
  EXPECT_LT(errors.rotation_rms_deg, 0.1);
}

TEST_F(HeadTrackers, ModelReachesThirtyDegreesOfYaw) {
  const auto tracker = tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  const Errors errors = follow(*tracker, sweep(30, 2, 50));
  EXPECT_EQ(errors.lost, 0);
  EXPECT_LT(errors.target_rms_mm, 0.35);
}

TEST_F(HeadTrackers, ModelLearnsDepthFromThePlainPairWhereThereIsNoCloud) {
  const auto tracker = tracking::makeModelHeadTracker(detector());
  start(*tracker, false);
  const Errors errors = follow(*tracker, sweep(10, 5));
  EXPECT_EQ(errors.lost, 0);
  EXPECT_LT(errors.target_rms_mm, 0.4);
  EXPECT_LT(errors.rotation_rms_deg, 0.25);
}

TEST_F(HeadTrackers, ModelHoldsAStillHeadWithinAFewHundredthsOfAMillimetre) {
  const auto tracker = tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  std::vector<SyntheticView> views;
  for (int i = 0; i < 8; ++i) views.push_back(stillView(i));
  EXPECT_LT(follow(*tracker, views).target_rms_mm, 0.08);
}

TEST_F(HeadTrackers, ModelBearsOtherLightAMovingJawAndACoveredCheek) {
  const auto tracker = tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  std::vector<SyntheticView> views;
  for (int i = 0; i < 8; ++i) {
    SyntheticView view = viewAt(i, 10);
    view.gain = 1.0 + 0.4 * (i % 2 ? 1 : -1) * std::min(1.0, i / 4.0);
    view.lamp_x = -0.3 + 0.1 * i;
    view.jaw_drop_mm = 1.0 * (i % 4);
    if (i > 2) view.cover_mm = cv::Rect2d(15, -80, 60, 75);
    views.push_back(view);
  }
  const Errors errors = follow(*tracker, views);
  EXPECT_EQ(errors.lost, 0);
  EXPECT_LT(errors.worst_mm, 1.0);
}

TEST_F(HeadTrackers, FirstFrameMayBeFarFromTheReference) {
  const auto tracker = tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  SyntheticView view = viewAt(12, 12);
  view.motion.pretranslate(Eigen::Vector3d(-30, 25, 50));
  const auto pose = tracker->track(face_->render(rig_, view));
  ASSERT_TRUE(pose.isTracked());
  EXPECT_LT(errorOf(*pose, view).at_point_mm, 0.3);
}

// What either tracker must refuse, after some good frames. Each case damages a good frame.
struct Damage {
  const char* name;
  std::function<void(stereo::StereoFrame&)> apply;
};

void fillNoise(cv::Mat& image, int seed) {
  cv::RNG random(static_cast<std::uint64_t>(seed));
  random.fill(image, cv::RNG::UNIFORM, 0, 255);
}

const Damage kDamages[] = {
    {"BlackLeft", [](auto& f) { f.left.setTo(2); }},
    {"BlackRight", [](auto& f) { f.right.setTo(0); }},
    {"Blank", [](auto& f) { f.left.setTo(128), f.right.setTo(128); }},
    {"Noise", [](auto& f) { fillNoise(f.left, 1), fillNoise(f.right, 2); }},
    {"SwappedSides", [](auto& f) { std::swap(f.left, f.right); }},
    {"Mirrored", [](auto& f) { cv::flip(f.left, f.left, 1), cv::flip(f.right, f.right, 1); }},
    {"SameImageTwice", [](auto& f) { f.right = f.left.clone(); }},
    {"OtherSize", [](auto& f) { f.left = f.left.colRange(0, 320).clone(); }},
    {"Empty", [](auto& f) { f.left = cv::Mat(); }},
    {"RightShiftedByTenLines",
     [](auto& f) {
       cv::Mat moved;
       cv::warpAffine(f.right, moved, cv::Matx23d(1, 0, 0, 0, 1, 10), f.right.size());
       f.right = moved;
     }},
};

TEST_F(HeadTrackers, RefuseEveryDamagedFrameAndGoOnAfterIt) {
  std::vector<stereo::StereoFrame> frames;
  for (int i = 0; i < 2 * int(std::size(kDamages)); ++i) frames.push_back(face_->render(rig_, viewAt(i, 8)));
  for (bool is_model : {true, false}) {
    const auto tracker = make(is_model);
    start(*tracker, true);
    std::size_t frame = 0;
    for (const auto& damage : kDamages) {
      ASSERT_TRUE(tracker->track(frames[frame++]).isTracked()) << "not found again, before " << damage.name;
      auto damaged = frames[frame++];
      damaged.left = damaged.left.clone(), damaged.right = damaged.right.clone();
      damage.apply(damaged);
      EXPECT_FALSE(tracker->track(damaged).isTracked())
          << damage.name << (is_model ? ", model" : ", features7");
    }
  }
}

TEST_F(HeadTrackers, SwappedSidesAreTheCamerasFault) {
  const auto tracker = tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  ASSERT_TRUE(tracker->track(face_->render(rig_, stillView(0))).isTracked());
  auto swapped = face_->render(rig_, stillView(1));
  std::swap(swapped.left, swapped.right);
  const auto pose = tracker->track(swapped);
  ASSERT_FALSE(pose.isTracked());
  EXPECT_EQ(pose.reason(), LostReason::camera);
}

TEST_F(HeadTrackers, AnotherPersonIsNotTracked) {
  const SyntheticFace stranger = SyntheticFace::stranger();
  std::vector<stereo::StereoFrame> frames = {face_->render(rig_, stillView(0))};
  for (int i = 1; i < 4; ++i) frames.push_back(stranger.render(rig_, stillView(i)));
  for (bool is_model : {true, false}) {
    const auto tracker = make(is_model);
    start(*tracker, true);
    ASSERT_TRUE(tracker->track(frames[0]).isTracked());
    for (std::size_t frame = 1; frame < 4; ++frame)
      EXPECT_FALSE(tracker->track(frames[frame]).isTracked()) << (is_model ? "model" : "features7");
  }
}

/// The portrait's coarse features, with pores and freckles of their own for each `seed`.
SyntheticFace withSkin(std::uint64_t seed) {
  cv::Mat1f portrait, pores;
  cv::imread(SyntheticFace::portraitPath(), cv::IMREAD_GRAYSCALE).convertTo(portrait, CV_32F);
  cv::resize(portrait, portrait, {}, 2, 2, cv::INTER_CUBIC);
  cv::GaussianBlur(portrait, portrait, {}, 2.5);
  pores.create(portrait.size());
  cv::RNG random(seed);
  random.fill(pores, cv::RNG::NORMAL, 0, 10);
  cv::GaussianBlur(pores, pores, {}, 0.8);
  return SyntheticFace(cv::Mat(portrait + pores), {390, 200}, {518, 208});
}

TEST_F(HeadTrackers, ATwinWithOtherPoresIsNotTracked) {
  const SyntheticFace patient = withSkin(1), twin = withSkin(2);
  const auto tracker = tracking::makeModelHeadTracker(detector());
  tracker->start(rig_, patient.reference(rig_, true));
  ASSERT_TRUE(tracker->track(patient.render(rig_, stillView(0))).isTracked());
  for (int i = 1; i < 5; ++i) EXPECT_FALSE(tracker->track(twin.render(rig_, stillView(i))).isTracked()) << i;
  EXPECT_TRUE(tracker->track(patient.render(rig_, stillView(5))).isTracked());
  tracker->forgetLearnt();
  EXPECT_FALSE(tracker->track(twin.render(rig_, stillView(6))).isTracked());
}

TEST_F(HeadTrackers, NoiseAndDimLightDoNotHideWhoseSkinItIs) {
  const SyntheticFace patient = withSkin(1), twin = withSkin(2);
  const auto dimView = [](int frame) {
    SyntheticView view = stillView(frame);
    view.gain = 0.4, view.noise_grey = 3.0;
    return view;
  };
  const auto tracker = tracking::makeModelHeadTracker(detector());
  tracker->start(rig_, patient.reference(rig_, true, dimView(0)));
  for (int i = 1; i < 4; ++i) {
    tracker->forgetLearnt();
    EXPECT_TRUE(tracker->track(patient.render(rig_, dimView(i))).isTracked()) << i;
    tracker->forgetLearnt();
    EXPECT_FALSE(tracker->track(twin.render(rig_, dimView(10 + i))).isTracked()) << i;
  }
}

TEST_F(HeadTrackers, AFaceLostIsFoundAgainElsewhereAtOnce) {
  const auto tracker = tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  ASSERT_TRUE(tracker->track(face_->render(rig_, viewAt(0, 10))).isTracked());
  SyntheticView hidden = viewAt(1, 10);
  hidden.cover_mm = cv::Rect2d(-200, -200, 400, 400);
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(tracker->track(face_->render(rig_, hidden)).isTracked());
  const SyntheticView back = viewAt(25, 10);
  const auto pose = tracker->track(face_->render(rig_, back));
  ASSERT_TRUE(pose.isTracked());
  EXPECT_LT(errorOf(*pose, back).at_point_mm, 0.3);
}

TEST_F(HeadTrackers, AFaceLostAtTheSideIsFoundAgainThere) {
  const auto tracker = tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  for (int i = 0; i <= 7; ++i)  // turning to 28 degrees
    ASSERT_TRUE(tracker->track(face_->render(rig_, turnedView(i, 4.0 * i))).isTracked()) << i;
  SyntheticView hidden = turnedView(8, 28);
  hidden.cover_mm = cv::Rect2d(-200, -200, 400, 400);
  EXPECT_FALSE(tracker->track(face_->render(rig_, hidden)).isTracked());
  SyntheticView back = turnedView(30, 26);  // longer ago than a prediction holds
  back.motion.pretranslate(Eigen::Vector3d(-25, 15, 20));
  int frames = 0;
  for (bool is_found = false; !is_found && frames < 6; ++frames) {
    back.seed = 100 + std::uint64_t(frames), back.time_s += 1.0 / 30;
    const auto pose = tracker->track(face_->render(rig_, back));
    is_found = pose.isTracked();
    if (is_found) {
      EXPECT_LT(errorOf(*pose, back).at_point_mm, 0.5);
    }
  }
  EXPECT_LT(frames, 6) << "0.2 s";
}

/// As between two axes of the paper's protractor, or with few frames a second. What a frame may cost is
/// bounded, so the fit may have to wait for the next one.
TEST_F(HeadTrackers, AFaceThatLeapsIsFoundInTheSameFrameOrTheNext) {
  const auto tracker = tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  int frame = 0;
  for (const double yaw_deg : {0.0, 10.0, -14.0, 12.0, -12.0, 14.0}) {
    bool is_found = false;
    for (int i = 0; i < 2 && !is_found; ++i) {
      const SyntheticView view = turnedView(frame++, yaw_deg);
      const auto pose = tracker->track(face_->render(rig_, view));
      is_found = pose.isTracked();
      if (is_found) {
        EXPECT_LT(errorOf(*pose, view).at_point_mm, 0.5) << yaw_deg << " deg";
      }
    }
    EXPECT_TRUE(is_found) << yaw_deg << " deg";
  }
}

/// The coil has waited: the head has the frame's first part only, but not in two frames running.
TEST_F(HeadTrackers, ALostFaceLeavesRoomForTheCoilAndIsFoundAllTheSame) {
  const auto tracker = tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  constexpr int kWanted = 3000;
  int frame = 0;
  for (const double yaw_deg : {0.0, 12.0, -14.0, 10.0}) {
    bool is_found = false;
    for (int i = 0; i < 4 && !is_found; ++i) {
      const SyntheticView view = turnedView(frame, yaw_deg);
      const auto image = face_->render(rig_, view);
      tracker->leave({kWanted});
      const auto pose = tracker->track(image);
      const int most = tracking::FrameWork::kMost - (frame++ % 2 == 0 ? kWanted : 0);
      EXPECT_LE(tracker->work().looks, most) << frame;
      is_found = pose.isTracked();
      if (is_found) {
        EXPECT_LT(errorOf(*pose, view).at_point_mm, 0.5) << yaw_deg << " deg";
      }
    }
    EXPECT_TRUE(is_found) << yaw_deg << " deg";
  }
}

TEST_F(HeadTrackers, AFrozenCameraIsNoticedInItsFirstRepeatedFrame) {
  const auto tracker = tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  auto frame = face_->render(rig_, stillView(0));
  for (int i = 1; i < 4; ++i) {
    frame = face_->render(rig_, stillView(i));
    ASSERT_TRUE(tracker->track(frame).isTracked());
  }
  frame.captured.s += 1.0 / 30;
  EXPECT_FALSE(tracker->track(frame).isTracked()) << "both repeat";
  EXPECT_EQ(tracker->lossDetail(), tracking::LossDetail::frozen);
  auto half = face_->render(rig_, stillView(6));
  half.left = frame.left;
  EXPECT_FALSE(tracker->track(half).isTracked()) << "one repeats";
  EXPECT_EQ(tracker->lossDetail(), tracking::LossDetail::frozen);
  EXPECT_TRUE(tracker->track(face_->render(rig_, stillView(7))).isTracked()) << "it goes on";
}

TEST_F(HeadTrackers, ALossSaysWhatItLooksLike) {
  const auto tracker = tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  ASSERT_TRUE(tracker->track(face_->render(rig_, stillView(0))).isTracked());
  SyntheticView view = stillView(1);
  view.cover_mm = cv::Rect2d(-200, -75, 400, 400);  // all but the upper forehead
  EXPECT_FALSE(tracker->track(face_->render(rig_, view)).isTracked());
  EXPECT_EQ(tracking::toString(tracker->lossDetail()), "covered");
  auto nobody = face_->render(rig_, stillView(2));
  fillNoise(nobody.left, 1), fillNoise(nobody.right, 2);
  EXPECT_FALSE(tracker->track(nobody).isTracked());
  EXPECT_EQ(tracking::toString(tracker->lossDetail()), "not_found");
  auto swapped = face_->render(rig_, stillView(3));
  std::swap(swapped.left, swapped.right);
  EXPECT_FALSE(tracker->track(swapped).isTracked());
  EXPECT_EQ(tracking::toString(tracker->lossDetail()), "swapped");
}

TEST_F(HeadTrackers, ALossOfAFaceThatIsBlurredOrTooFarSaysSo) {
  const auto tracker = tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  ASSERT_TRUE(tracker->track(face_->render(rig_, stillView(0))).isTracked());
  cv::theRNG().state = 5;
  SyntheticView noiseless = stillView(1);
  noiseless.noise_grey = 0;
  auto blurred = face_->render(rig_, noiseless);
  for (cv::Mat* image : {&blurred.left, &blurred.right}) {  // the lens blurs, then the sensor adds its noise
    cv::Mat1f grey, noise(image->size());
    image->convertTo(grey, CV_32F);
    cv::GaussianBlur(grey, grey, {}, 6.0);
    cv::randn(noise, 0, 1.5);
    cv::Mat(grey + noise).convertTo(*image, CV_8U);
  }
  EXPECT_FALSE(tracker->track(blurred).isTracked());
  EXPECT_EQ(tracking::toString(tracker->lossDetail()), "blurred");
  bool is_tracked = true;
  for (int i = 2; i < 30 && is_tracked; ++i) {  // walks away
    SyntheticView view = stillView(i);
    view.motion = Eigen::Translation3d(0, 0, 90.0 * (i - 1));
    const auto pose = tracker->track(face_->render(rig_, view));
    is_tracked = pose.isTracked();
    if (is_tracked) {
      EXPECT_LT(errorOf(*pose, view).at_point_mm, 3.0) << i;
    }
  }
  EXPECT_FALSE(is_tracked);
  EXPECT_EQ(tracking::toString(tracker->lossDetail()), "too_far");
}

/// Whoever sat near is not far off a tenth of a second later, whatever looks like it: as where a hand over
/// the face leads fits astray.
TEST_F(HeadTrackers, NobodyIsTooFarAMomentAfterBeingNear) {
  const auto tracker = tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  ASSERT_TRUE(tracker->track(face_->render(rig_, stillView(0))).isTracked());
  for (int i = 1; i < 5; ++i) {
    SyntheticView view = stillView(i);
    view.motion = Eigen::Translation3d(0, 0, 700);
    EXPECT_FALSE(tracker->track(face_->render(rig_, view)).isTracked());
    EXPECT_NE(tracking::toString(tracker->lossDetail()), "too_far") << i;
  }
}

TEST_F(HeadTrackers, AHeadThatStartsAtTheSideIsFoundThere) {
  const auto tracker = tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  for (const auto& [yaw_deg, nod_deg, lean_deg] :
       {std::array{30.0, 0.0, 10.0}, std::array{-30.0, 10.0, 0.0}, std::array{22.0, -15.0, -15.0}}) {
    tracker->forgetLearnt();
    int frame = 0;
    for (; frame < 6; ++frame) {  // 0.2 s at 30 fps
      SyntheticView view = turnedView(frame, yaw_deg);
      view.motion = view.motion * Eigen::Translation3d(0, 0, 640) *
                    Eigen::AngleAxisd(nod_deg * kDegree, Eigen::Vector3d::UnitX()) *
                    Eigen::AngleAxisd(lean_deg * kDegree, Eigen::Vector3d::UnitZ()) *
                    Eigen::Translation3d(0, 0, -640);
      const auto pose = tracker->track(face_->render(rig_, view));
      if (!pose) continue;
      EXPECT_LT(errorOf(*pose, view).at_point_mm, 1.5) << yaw_deg;
      break;
    }
    EXPECT_LT(frame, 6) << yaw_deg << ' ' << nod_deg << ' ' << lean_deg;
  }
}

TEST_F(HeadTrackers, TheSameFramesGiveTheSamePoses) {
  const auto frame = face_->render(rig_, viewAt(5, 10));
  Eigen::Matrix4d poses[2];
  for (auto& matrix : poses) {
    const auto tracker = tracking::makeModelHeadTracker(detector());
    start(*tracker, true);
    const auto pose = tracker->track(frame);
    ASSERT_TRUE(pose.isTracked());
    matrix = pose->camera_T_head.matrix();
  }
  EXPECT_EQ((poses[0] - poses[1]).cwiseAbs().maxCoeff(), 0.0);
}

TEST_F(HeadTrackers, RefuseToStartWithoutAFace) {
  tracking::HeadReference nothing;
  nothing.frame.left = cv::Mat(480, 640, CV_8U, cv::Scalar(90));
  nothing.frame.right = nothing.frame.left.clone();
  EXPECT_THROW(tracking::makeModelHeadTracker(detector())->start(rig_, nothing), Error);
  EXPECT_THROW(tracking::makeFeatureHeadTracker(detector())->start(rig_, nothing), Error);
}

}  // namespace
}  // namespace facenav
