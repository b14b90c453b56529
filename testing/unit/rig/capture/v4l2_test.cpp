// The Video4Linux backend against a fake kernel (support/fake_v4l2.h).

#include <gmock/gmock.h>

#include "v4l2_bench.h"

namespace facenav::capture {
namespace {

using testing::faultOf;
using ::testing::HasSubstr;

const ControlState& control(const CameraState& state, const std::string& name) {
  for (const auto& one : state.controls)
    if (one.name == name) return one;
  throw std::logic_error("no control " + name);
}

TEST(V4l2, KeepsTheContractOfCamerasAndLeavesNothingOpen) {
  V4l2Bench bench;
  testing::expectCameraContract(bench);
  EXPECT_EQ(bench.kernel().open_devices, 0);
  EXPECT_EQ(bench.kernel().mapped_buffers, 0);
}

TEST(V4l2, TwoKeepTheContractOfLivePairs) {
  const auto kernel = std::make_shared<FakeV4l2>();
  V4l2Bench left(kernel, "/dev/video0"), right(kernel, "/dev/video2");
  testing::expectLivePairContract(left, right);
  EXPECT_EQ(kernel->open_devices, 0);
}

TEST(V4l2, OneCameraIsNoPair) {
  V4l2Bench bench;
  EXPECT_THROW(testing::openPair(bench, bench), Error);
}

TEST(V4l2, DecodesEveryFormatAndItsPaddedLines) {
  for (const auto& [code, name, error] :
       {std::tuple(V4L2_PIX_FMT_GREY, "GREY", 0.0), std::tuple(V4L2_PIX_FMT_YUYV, "YUYV", 0.0),
        std::tuple(V4L2_PIX_FMT_MJPEG, "MJPG", 12.0)}) {
    V4l2Bench bench;
    bench.camera().modes = {{std::uint32_t(code), 64, 48, 100}};
    const auto camera = bench.running();
    EXPECT_EQ(camera->state().format, name);
    const auto picture = camera->next(1.0);
    ASSERT_TRUE(picture);
    EXPECT_LE(cv::norm(picture->grey,
                       testing::numberedPicture(
                           64, 48, picture->sequence + bench.camera().pictures - picture->sequence),
                       cv::NORM_INF),
              error)
        << name;
  }
}

TEST(V4l2, TakesTheFormatThatIsFastEnough) {
  V4l2Bench bench;
  bench.camera().modes = {{V4L2_PIX_FMT_YUYV, 64, 48, 10}, {V4L2_PIX_FMT_MJPEG, 64, 48, 100}};
  EXPECT_EQ(bench.open()->configure(bench.settings()).format, "MJPG");
  auto wanted = bench.settings();
  wanted.format = "YUYV";
  const auto state = bench.open()->configure(wanted);
  EXPECT_EQ(state.format, "YUYV");
  ASSERT_EQ(state.notes.size(), 1u);
  EXPECT_THAT(state.notes[0], HasSubstr("10 pictures a second"));
}

TEST(V4l2, ADriverThatGivesAnotherSizeIsNotBelieved) {
  V4l2Bench bench;
  bench.camera().forced_width = 80;
  std::string words;
  EXPECT_EQ(faultOf([&] { bench.open()->configure(bench.settings()); }, &words), CameraFault::wrong_size);
  EXPECT_THAT(words, HasSubstr("80 x 48"));
}

TEST(V4l2, LocksTheAdjustmentsWhereTheyAreAndReadsThemBack) {
  V4l2Bench bench;
  const auto state = bench.open()->configure(bench.settings());
  EXPECT_TRUE(unlockedInWords(state).empty());
  EXPECT_EQ(bench.camera().controls[V4L2_CID_EXPOSURE_AUTO].value, V4L2_EXPOSURE_MANUAL);
  EXPECT_EQ(bench.camera().controls[V4L2_CID_FOCUS_AUTO].value, 0);
  EXPECT_EQ(bench.camera().controls[V4L2_CID_AUTO_WHITE_BALANCE].value, 0);
  EXPECT_EQ(control(state, "exposure").lock, ControlState::Lock::locked);
  EXPECT_DOUBLE_EQ(*control(state, "exposure").actual, 15.6);
  EXPECT_DOUBLE_EQ(*control(state, "focus").actual, 30);
}

TEST(V4l2, SetsWantedValuesInTheirUnits) {
  V4l2Bench bench;
  auto settings = bench.settings();
  settings.exposure_ms = 5.0;
  settings.white_balance_k = 5200;
  const auto state = bench.open()->configure(settings);
  EXPECT_EQ(bench.camera().controls[V4L2_CID_EXPOSURE_ABSOLUTE].value, 50);
  EXPECT_EQ(bench.camera().controls[V4L2_CID_WHITE_BALANCE_TEMPERATURE].value, 5200);
  EXPECT_TRUE(unlockedInWords(state).empty());
}

TEST(V4l2, LocksTheExposureThatItFoundForThisLight) {
  V4l2Bench bench;
  const auto camera = bench.open();
  camera->configure(bench.settings());
  auto adjusting = bench.settings();
  adjusting.is_adjusting = true;
  camera->configure(adjusting);
  EXPECT_EQ(bench.camera().controls[V4L2_CID_FOCUS_AUTO].value, 1);
  camera->start();
  ASSERT_TRUE(camera->next(1.0));
  const auto state = camera->configure(bench.settings());
  EXPECT_DOUBLE_EQ(*control(state, "exposure").actual, 33.3);
  EXPECT_TRUE(unlockedInWords(state).empty());
}

TEST(V4l2, SaysWhatTheDriverRefuses) {
  V4l2Bench bench;
  bench.camera().controls[V4L2_CID_FOCUS_AUTO].is_stuck = true;
  bench.camera().controls[V4L2_CID_GAIN].is_stuck = true;
  bench.camera().controls.erase(V4L2_CID_WHITE_BALANCE_TEMPERATURE);
  bench.camera().controls.erase(V4L2_CID_AUTO_WHITE_BALANCE);
  auto settings = bench.settings();
  settings.gain = 100;
  settings.exposure_ms = 900;
  const auto state = bench.open()->configure(settings);
  EXPECT_THAT(unlockedInWords(state),
              ::testing::ElementsAre("exposure: 900 ms is outside the camera's range, 0.3 to 204.7 ms",
                                     "gain: 100 was asked for, the camera keeps 32",
                                     "focus: the camera stays on automatic"));
  EXPECT_EQ(control(state, "white balance").lock, ControlState::Lock::absent);
}

TEST(V4l2, ACameraWithoutExposureControlIsNotCalledLocked) {
  V4l2Bench bench;
  bench.camera().controls.clear();
  const auto state = bench.open()->configure(bench.settings());
  ASSERT_EQ(unlockedInWords(state).size(), 1u);
  EXPECT_THAT(unlockedInWords(state)[0], HasSubstr("exposure: the camera has no such control"));
}

TEST(V4l2, LocksAgainWhatACameraForgetsWhenItStarts) {
  V4l2Bench bench;
  auto& exposure = bench.camera().controls[V4L2_CID_EXPOSURE_AUTO];
  exposure.forgets_at_start = true;
  exposure.at_start = V4L2_EXPOSURE_APERTURE_PRIORITY;
  auto camera = bench.running();
  EXPECT_TRUE(unlockedInWords(camera->state()).empty());
  EXPECT_EQ(exposure.value, V4L2_EXPOSURE_MANUAL);
  camera.reset();
  camera = bench.open();
  camera->configure(bench.settings());
  exposure.is_stuck = true;  // from now on it refuses
  camera->start();
  EXPECT_THAT(unlockedInWords(camera->state()),
              ::testing::ElementsAre("exposure: the camera stays on automatic"));
}

TEST(V4l2, FallsBackToCompressedPicturesWhereTheBandwidthIsShort) {
  V4l2Bench bench;
  bench.camera().is_bandwidth_short = true;
  const auto camera = bench.running();
  EXPECT_EQ(camera->state().format, "MJPG");
  EXPECT_THAT(camera->state().notes, ::testing::Contains(HasSubstr("compressed")));
  EXPECT_TRUE(camera->next(1.0));
  auto raw = bench.settings();
  raw.format = "YUYV";
  const auto second = bench.open();
  second->configure(raw);
  std::string words;
  EXPECT_EQ(faultOf([&] { second->start(); }, &words), CameraFault::no_bandwidth);
  EXPECT_THAT(words, HasSubstr("different USB controllers"));
}

TEST(V4l2, CountsWhatIsDroppedDamagedAndRepeated) {
  V4l2Bench bench;
  const auto camera = bench.running();
  const auto before = camera->next(1.0);
  bench.camera().drop = 3;
  const auto after = camera->next(1.0);
  ASSERT_TRUE(before && after);
  EXPECT_EQ(after->sequence - before->sequence, 4);
  EXPECT_EQ(camera->counts().dropped, 3);
  bench.camera().damage = 2;
  bench.camera().lose = 1;
  EXPECT_TRUE(camera->next(1.0));
  EXPECT_EQ(camera->counts().damaged, 3);
  bench.camera().repeat = 2;
  const auto third = camera->next(1.0), fourth = camera->next(1.0);
  ASSERT_TRUE(third && fourth);
  EXPECT_EQ(camera->counts().repeated, 2);
  EXPECT_GT(cv::norm(third->grey, fourth->grey, cv::NORM_INF), 0);
}

TEST(V4l2, AJpegThatIsCutShortIsNoPicture) {
  V4l2Bench bench;
  bench.camera().modes = {{V4L2_PIX_FMT_MJPEG, 64, 48, 100}};
  const auto camera = bench.running();
  bench.camera().damage = 1;
  ASSERT_TRUE(camera->next(1.0));
  EXPECT_EQ(camera->counts().damaged, 1);
}

TEST(V4l2, TakesTheDriversTimeOfCapture) {
  V4l2Bench bench;
  bench.camera().stamp_shift_s = -0.030;  // the driver stamps the start of exposure, 30 ms ago
  const auto camera = bench.running();
  const auto picture = camera->next(1.0);
  ASSERT_TRUE(picture);
  EXPECT_GE(Timestamp::now() - picture->captured, 0.030);
  EXPECT_THAT(camera->state().clock, HasSubstr("start of exposure"));
}

TEST(V4l2, ATimeStampThatJumpsIsReplacedAndCounted) {
  V4l2Bench bench;
  const auto camera = bench.running();
  const auto before = camera->next(1.0);
  bench.camera().stamp_shift_s = 100.0;
  const auto jumped = camera->next(1.0);
  bench.camera().stamp_shift_s = 0.0;
  const auto after = camera->next(1.0);
  ASSERT_TRUE(before && jumped && after);
  EXPECT_NEAR(jumped->captured - before->captured, 0.01, 0.009);
  EXPECT_GT(after->captured.s, jumped->captured.s);
  EXPECT_EQ(camera->counts().clock_steps, 1);
}

TEST(V4l2, TimeStampsOfAnotherClockAreFitted) {
  V4l2Bench bench;
  bench.camera().stamp_flags = V4L2_BUF_FLAG_TIMESTAMP_UNKNOWN;
  bench.camera().stamp_shift_s = 1e6;
  const auto camera = bench.running();
  for (int i = 0; i < 5; ++i) {
    const auto picture = camera->next(1.0);
    ASSERT_TRUE(picture);
    EXPECT_LT(Timestamp::now() - picture->captured, 0.5);
    EXPECT_GE(Timestamp::now() - picture->captured, 0.0);
  }
  EXPECT_THAT(camera->state().clock, HasSubstr("fitted"));
}

TEST(V4l2, ACameraInUseIsSaidAtEveryStep) {
  V4l2Bench bench;
  bench.camera().is_busy = true;
  std::string words;
  EXPECT_EQ(faultOf([&] { bench.open()->configure(bench.settings()); }, &words), CameraFault::in_use);
  EXPECT_THAT(words, HasSubstr("in use by another program"));
  bench.camera().is_busy = false;
  const auto camera = bench.open();
  camera->configure(bench.settings());
  bench.camera().is_busy = true;
  EXPECT_EQ(faultOf([&] { camera->start(); }), CameraFault::in_use);
  bench.camera().open_error = EACCES;
  EXPECT_EQ(faultOf([&] { bench.open(); }, &words), CameraFault::no_permission);
  EXPECT_THAT(words, HasSubstr("group 'video'"));
}

}  // namespace
}  // namespace facenav::capture
