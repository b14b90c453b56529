// Frames and faces that a head tracker must not accept as the patient's, and the reason that it gives.

#include "head_scene.h"

namespace facenav {
namespace {

using namespace head_tracking::testing;
using testing::SyntheticFace;
using testing::SyntheticView;

// Damage to a good frame. Either tracker must refuse the result, after some good frames.
struct Damage {
  const char* name;
  std::function<void(cameras::StereoFrame&)> apply;
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
  std::vector<cameras::StereoFrame> frames;
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
  const auto tracker = head_tracking::makeModelHeadTracker(detector());
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
  std::vector<cameras::StereoFrame> frames = {face_->render(rig_, stillView(0))};
  for (int i = 1; i < 4; ++i) frames.push_back(stranger.render(rig_, stillView(i)));
  for (bool is_model : {true, false}) {
    const auto tracker = make(is_model);
    start(*tracker, true);
    ASSERT_TRUE(tracker->track(frames[0]).isTracked());
    for (std::size_t frame = 1; frame < 4; ++frame)
      EXPECT_FALSE(tracker->track(frames[frame]).isTracked()) << (is_model ? "model" : "features7");
  }
}

/// The portrait's coarse features, with individual pores and freckles for each `seed`.
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
  // With `patient`, each frame waits for recovery, whose windows alone take the twin for the patient.
  for (const auto pace : {head_tracking::Pace::live, head_tracking::Pace::patient}) {
    const auto tracker = head_tracking::makeModelHeadTracker(detector());
    tracker->start(rig_, patient.reference(rig_, true), pace);
    ASSERT_TRUE(tracker->track(patient.render(rig_, stillView(0))).isTracked());
    for (int i = 1; i < 5; ++i)
      EXPECT_FALSE(tracker->track(twin.render(rig_, stillView(i))).isTracked()) << i;
    EXPECT_TRUE(tracker->track(patient.render(rig_, stillView(5))).isTracked());
    EXPECT_FALSE(tracker->track(twin.render(rig_, stillView(6)), {{}, true}).isTracked());
  }
}

TEST_F(HeadTrackers, NoiseAndDimLightDoNotHideWhoseSkinItIs) {
  const SyntheticFace patient = withSkin(1), twin = withSkin(2);
  const auto dimView = [](int frame) {
    SyntheticView view = stillView(frame);
    view.gain = 0.4, view.noise_grey = 3.0;
    return view;
  };
  const auto tracker = head_tracking::makeModelHeadTracker(detector());
  tracker->start(rig_, patient.reference(rig_, true, dimView(0)));
  for (int i = 1; i < 4; ++i) {
    EXPECT_TRUE(tracker->track(patient.render(rig_, dimView(i)), {{}, true}).isTracked()) << i;
    EXPECT_FALSE(tracker->track(twin.render(rig_, dimView(10 + i)), {{}, true}).isTracked()) << i;
  }
}

TEST_F(HeadTrackers, AFrozenCameraIsNoticedInItsFirstRepeatedFrame) {
  const auto tracker = head_tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  auto frame = face_->render(rig_, stillView(0));
  for (int i = 1; i < 4; ++i) {
    frame = face_->render(rig_, stillView(i));
    ASSERT_TRUE(tracker->track(frame).isTracked());
  }
  frame.captured.s += 1.0 / 30;
  EXPECT_EQ(wordOf(tracker->track(frame)), "frozen") << "both repeat";
  auto half = face_->render(rig_, stillView(6));
  half.left = frame.left;
  EXPECT_EQ(wordOf(tracker->track(half)), "frozen") << "one repeats";
  EXPECT_TRUE(tracker->track(face_->render(rig_, stillView(7))).isTracked()) << "it goes on";
}

TEST_F(HeadTrackers, ALossSaysWhatItLooksLike) {
  const auto tracker = head_tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  ASSERT_TRUE(tracker->track(face_->render(rig_, stillView(0))).isTracked());
  SyntheticView view = stillView(1);
  view.cover_mm = cv::Rect2d(-200, -75, 400, 400);  // all but the upper forehead
  EXPECT_EQ(wordOf(tracker->track(face_->render(rig_, view))), "covered");
  auto nobody = face_->render(rig_, stillView(2));
  fillNoise(nobody.left, 1), fillNoise(nobody.right, 2);
  EXPECT_EQ(wordOf(tracker->track(nobody)), "not_found");
  auto swapped = face_->render(rig_, stillView(3));
  std::swap(swapped.left, swapped.right);
  EXPECT_EQ(wordOf(tracker->track(swapped)), "swapped");
}

TEST_F(HeadTrackers, ALossOfAFaceThatIsBlurredOrTooFarSaysSo) {
  const auto tracker = head_tracking::makeModelHeadTracker(detector());
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
  EXPECT_EQ(wordOf(tracker->track(blurred)), "blurred");
  std::string word;
  for (int i = 2; i < 30 && word.empty(); ++i) {  // walks away
    SyntheticView view = stillView(i);
    view.motion = Eigen::Translation3d(0, 0, 90.0 * (i - 1));
    const auto pose = tracker->track(face_->render(rig_, view));
    word = wordOf(pose);
    if (pose) {
      EXPECT_LT(errorOf(*pose, view).at_point_mm, 3.0) << i;
    }
  }
  EXPECT_EQ(word, "too_far");
}

/// A near head cannot be far away a tenth of a second later: a hand over the face can mislead a fit.
TEST_F(HeadTrackers, NobodyIsTooFarAMomentAfterBeingNear) {
  const auto tracker = head_tracking::makeModelHeadTracker(detector());
  start(*tracker, true);
  ASSERT_TRUE(tracker->track(face_->render(rig_, stillView(0))).isTracked());
  for (int i = 1; i < 5; ++i) {
    SyntheticView view = stillView(i);
    view.motion = Eigen::Translation3d(0, 0, 700);
    const std::string word = wordOf(tracker->track(face_->render(rig_, view)));
    EXPECT_FALSE(word.empty()) << i;
    EXPECT_NE(word, "too_far") << i;
  }
}

}  // namespace
}  // namespace facenav
