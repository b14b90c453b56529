// The mean of pictures of a face that does not move.

#include "steady_mean.h"

#include <gmock/gmock.h>

#include <opencv2/imgproc.hpp>

namespace facenav::steps {
namespace {

const cv::Rect kFace(100, 60, 160, 160), kMarker(90, 150, 40, 40);
constexpr double kNoise_grey = 4.0;

/// Blotches of skin, moved sideways, or rotated about the middle of the face.
cv::Mat skin(double by_px, double turned_deg = 0.0) {
  cv::Mat drawn(300, 400, CV_32F), moved;
  cv::RNG random(3);
  random.fill(drawn, cv::RNG::NORMAL, 0.0, 200.0);
  cv::GaussianBlur(drawn, drawn, {}, 4.0);
  cv::Mat motion = cv::getRotationMatrix2D({180.0F, 140.0F}, turned_deg, 1.0);
  motion.at<double>(0, 2) += by_px;
  cv::warpAffine(drawn + 120.0, moved, motion, drawn.size(), cv::INTER_CUBIC, cv::BORDER_REPLICATE);
  return moved;
}

cv::Mat photographed(const cv::Mat& light, unsigned seed) {
  cv::Mat noise(light.size(), CV_32F), grey;
  cv::RNG random(seed);
  random.fill(noise, cv::RNG::NORMAL, 0.0, kNoise_grey);
  cv::Mat(light + noise).convertTo(grey, CV_8U);
  return grey;
}

std::deque<cameras::StereoFrame> frames(int count, double left_moves_px, double right_moves_px) {
  std::deque<cameras::StereoFrame> all;
  for (int i = 0; i < count; ++i) {
    const bool is_last = i + 1 == count;
    cameras::StereoFrame frame;
    frame.number = i;
    frame.left = photographed(skin(is_last ? 0.0 : left_moves_px), 10u + unsigned(i));
    frame.right = photographed(skin(is_last ? 0.0 : right_moves_px), 50u + unsigned(i));
    all.push_back(frame);
  }
  return all;
}

/// Root mean square against the picture without noise, over the face without the marker.
double noiseOf(const cv::Mat& grey) {
  cv::Mat off, one, inside = cv::Mat::zeros(grey.size(), CV_8U);
  grey.convertTo(one, CV_32F);
  off = one - skin(0.0);
  inside(kFace) = 255;
  inside(kMarker) = 0;
  return cv::norm(off, cv::NORM_L2, inside) / std::sqrt(double(cv::countNonZero(inside)));
}

TEST(SteadyMean, OfEightPicturesHasAThirdOfTheNoise) {
  const auto all = frames(8, 0.0, 0.05);
  const auto [mean, pictures] = steadyMean(all, {kFace, kMarker}, {kFace, kMarker});
  EXPECT_GE(pictures, 6);
  EXPECT_NEAR(noiseOf(all.back().left), kNoise_grey, 0.3);
  EXPECT_LT(noiseOf(mean.left), 0.42 * kNoise_grey);
  EXPECT_LT(noiseOf(mean.right), 0.5 * kNoise_grey);
  EXPECT_EQ(mean.number, 7);
}

TEST(SteadyMean, ChangesTheFaceAlone) {
  const auto all = frames(4, 0.0, 0.0);
  const auto mean = steadyMean(all, {kFace, kMarker}, {kFace, kMarker}).frame;
  cv::Mat changed = mean.left != all.back().left;
  EXPECT_GT(cv::countNonZero(changed(kFace)), 0);
  EXPECT_EQ(cv::countNonZero(changed(kMarker)), 0);
  changed(kFace) = 0;
  EXPECT_EQ(cv::countNonZero(changed), 0);
  EXPECT_NE(mean.left.data, all.back().left.data);
}

TEST(SteadyMean, LeavesOutAPictureInWhichTheFaceMovedInEitherCamera) {
  for (const auto& [left_px, right_px] : {std::pair{0.4, 0.0}, {0.0, 0.4}, {3.0, 3.0}}) {
    const auto all = frames(3, left_px, right_px);
    const auto [mean, pictures] = steadyMean(all, {kFace, kMarker}, {kFace, kMarker});
    EXPECT_EQ(pictures, 1);
    EXPECT_EQ(cv::norm(mean.left, all.back().left, cv::NORM_INF), 0) << left_px << ", " << right_px;
    EXPECT_EQ(cv::norm(mean.right, all.back().right, cv::NORM_INF), 0);
  }
}

TEST(SteadyMean, LeavesOutAFaceThatTurnsAboutItsMiddle) {
  auto all = frames(2, 0.0, 0.0);
  all.front().left = photographed(skin(0.0, 0.6), 77);
  const auto mean = steadyMean(all, {kFace, kMarker}, {kFace, kMarker}).frame;
  EXPECT_EQ(cv::norm(mean.left, all.back().left, cv::NORM_INF), 0);
}

TEST(SteadyMean, OfAFaceBeyondThePictureIsTheNewest) {
  const auto all = frames(3, 0.0, 0.0);
  for (const cv::Rect& face : {cv::Rect(390, 60, 160, 160), cv::Rect(500, 500, 100, 100), cv::Rect()}) {
    const auto mean = steadyMean(all, {face, kMarker}, {kFace, kMarker}).frame;
    EXPECT_EQ(cv::norm(mean.left, all.back().left, cv::NORM_INF), 0);
    EXPECT_EQ(cv::norm(mean.right, all.back().right, cv::NORM_INF), 0);
  }
}

}  // namespace
}  // namespace facenav::steps
