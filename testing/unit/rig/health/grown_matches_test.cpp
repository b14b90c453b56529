#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "facenav/health/pair_matches.h"

namespace facenav::health {

using namespace cameras;
namespace {

const Eigen::Vector2d kShift_px(7.3, -2.4);

cv::Mat texture(int seed) {
  cv::RNG random(seed);
  cv::Mat noise(320, 400, CV_32F), smooth, picture;
  random.fill(noise, cv::RNG::NORMAL, 0, 1);
  cv::GaussianBlur(noise, smooth, {}, 3.0);
  smooth.convertTo(picture, CV_8U, 200, 128);
  return picture;
}

/// Shifts every point of the picture by kShift_px.
cv::Mat moved(const cv::Mat& picture) {
  cv::Mat out;
  const cv::Matx23d by(1, 0, kShift_px.x(), 0, 1, kShift_px.y());
  cv::warpAffine(picture, out, by, picture.size(), cv::INTER_CUBIC, cv::BORDER_REFLECT);
  return out;
}

std::vector<Correspondence> seeds() {
  std::vector<Correspondence> at;
  for (int v = 0; v < 3; ++v)
    for (int u = 0; u < 3; ++u) {
      const Eigen::Vector2d left_px(100 + 8 * u, 150 + 8 * v);
      at.push_back({left_px, left_px + kShift_px, 0.1});
    }
  return at;
}

TEST(GrowMatches, CoversTheWholeSceneFromAFewSeeds) {
  const cv::Mat left = texture(5);
  const auto found = growMatches(left, moved(left), seeds());
  EXPECT_GT(found.size(), 700u);  // of 35 x 27 windows inside the margins
  for (const auto& match : found)
    EXPECT_LT((match.right_px - match.left_px - kShift_px).norm(), 0.15) << match.left_px.transpose();
}

TEST(GrowMatches, EndsWhereThePicturesShowDifferentThings) {
  const cv::Mat left = texture(5);
  cv::Mat right = moved(left);
  const cv::Rect other(220, 0, 180, 320);
  texture(6)(other).copyTo(right(other));
  const auto found = growMatches(left, right, seeds());
  EXPECT_GT(found.size(), 250u);
  for (const auto& match : found) EXPECT_LT(match.left_px.x(), 220) << match.left_px.transpose();
}

TEST(GrowMatches, FindsNothingWithoutSeedsOrTexture) {
  const cv::Mat left = texture(5);
  EXPECT_TRUE(growMatches(left, moved(left), {}).empty());
  const cv::Mat plain(320, 400, CV_8U, cv::Scalar(128));
  EXPECT_TRUE(growMatches(plain, plain, seeds()).empty());
}

}  // namespace
}  // namespace facenav::health
