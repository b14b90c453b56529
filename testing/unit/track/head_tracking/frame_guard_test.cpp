#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "frame_guard.h"

namespace facenav::head_tracking {
namespace {

const cv::Rect kFace(60, 40, 80, 90);

// An image with a face-like patch that moves by `shift_px`; with noise when sigma > 0.
cameras::StereoFrame frameAt(double time_s, int shift_px, double sigma, int seed) {
  cameras::StereoFrame frame;
  cv::RNG random(static_cast<std::uint64_t>(seed + 1));
  for (cv::Mat* image : {&frame.left, &frame.right}) {
    cv::Mat1f picture(160, 200);
    for (int y = 0; y < picture.rows; ++y)
      for (int x = 0; x < picture.cols; ++x)
        picture(y, x) = float(kFace.contains({x - shift_px, y})
                                  ? 120 + 60 * std::sin((x - shift_px) / 3.0) * std::cos(y / 4.0)
                                  : 60 + x / 5);
    if (sigma > 0) {
      cv::Mat1f noise(picture.size());
      random.fill(noise, cv::RNG::NORMAL, 0, sigma);
      picture += noise;
    }
    picture.convertTo(*image, CV_8U);
  }
  frame.captured.s = time_s;
  return frame;
}

TEST(FrameGuard, NoisyStillFramesPass) {
  FrameGuard guard;
  guard.start(frameAt(0, 0, 1.5, 0));
  for (int i = 1; i < 20; ++i) EXPECT_FALSE(guard.check(frameAt(i / 60.0, 0, 1.5, i), 0.2, kFace, kFace));
}

TEST(FrameGuard, AFrozenPairIsStaleWhereTheStreamHasShownNoise) {
  FrameGuard guard;
  guard.start(frameAt(0, 0, 1.5, 0));
  for (int i = 1; i < 6; ++i) guard.check(frameAt(i / 60.0, 0, 1.5, i), 0.2, kFace, kFace);
  auto frozen = frameAt(5 / 60.0, 0, 1.5, 5);
  frozen.captured.s = 6 / 60.0;
  EXPECT_EQ(guard.check(frozen, 0.2, kFace, kFace), LostReason::stale) << "from the first repeated image on";
  EXPECT_EQ(guard.detail(), LossDetail::frozen);
  frozen.captured.s = 7 / 60.0;
  EXPECT_EQ(guard.check(frozen, 0.2, kFace, kFace), LostReason::stale);
  EXPECT_FALSE(guard.check(frameAt(8 / 60.0, 0, 1.5, 8), 0.2, kFace, kFace)) << "new images again";
}

TEST(FrameGuard, AFrozenPairOfAFastHeadIsStaleAtOnce) {
  FrameGuard guard;
  guard.start(frameAt(0, 0, 1.5, 0));
  for (int i = 1; i < 6; ++i) guard.check(frameAt(i / 60.0, i, 1.5, i), 100, kFace, kFace);
  auto frozen = frameAt(5 / 60.0, 5, 1.5, 5);
  frozen.captured.s = 6 / 60.0;
  EXPECT_EQ(guard.check(frozen, 100, kFace, kFace), LostReason::stale);
}

TEST(FrameGuard, RepeatedImagesOfAStillHeadWithoutNoisePass) {
  FrameGuard guard;
  guard.start(frameAt(0, 0, 0, 0));
  for (int i = 1; i < 100; ++i) EXPECT_FALSE(guard.check(frameAt(i / 60.0, 0, 0, i), 0.0, kFace, kFace));
}

TEST(FrameGuard, RepeatedImagesOfAMovingHeadWithoutNoiseAreStale) {
  FrameGuard guard;
  guard.start(frameAt(0, 0, 0, 0));
  for (int i = 1; i < 6; ++i) EXPECT_FALSE(guard.check(frameAt(i / 60.0, i, 0, i), 40, kFace, kFace));
  for (int i = 6; i < 9; ++i)
    EXPECT_EQ(guard.check(frameAt(i / 60.0, 5, 0, i), 40, kFace, kFace), LostReason::stale);
}

TEST(FrameGuard, OneFrozenCameraIsACameraFault) {
  for (double sigma : {0.0, 1.5}) {
    FrameGuard guard;
    guard.start(frameAt(0, 0, sigma, 0));
    for (int i = 1; i < 6; ++i) guard.check(frameAt(i / 60.0, i, sigma, i), 10, kFace, kFace);
    auto frame = frameAt(6 / 60.0, 6, sigma, 6);
    frame.left = frameAt(5 / 60.0, 5, sigma, 5).left;
    EXPECT_EQ(guard.check(frame, 10, kFace, kFace), LostReason::camera) << "sigma " << sigma;
  }
}

TEST(FrameGuard, BlackBlankAndMissizedImagesAreACameraFault) {
  FrameGuard guard;
  guard.start(frameAt(0, 0, 1.5, 0));
  auto black = frameAt(0.1, 0, 1.5, 1), blank = frameAt(0.2, 0, 1.5, 2), colour = frameAt(0.3, 0, 1.5, 3);
  black.right.setTo(1);
  blank.left.setTo(200);
  cv::cvtColor(colour.left, colour.left, cv::COLOR_GRAY2BGR);
  for (const auto& frame : {black, blank, colour})
    EXPECT_EQ(guard.check(frame, 0, kFace, kFace), LostReason::camera);
}

}  // namespace
}  // namespace facenav::head_tracking
