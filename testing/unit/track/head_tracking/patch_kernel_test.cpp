// Head tracking's inner loop: both kernels give the same sums, and the blur is binomial without rounding.

#include "head/patch_kernel.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <vector>

#include "head/image_pyramid.h"

namespace facenav::head_tracking {
namespace {

cv::Mat noiseImage(int rows, int columns) {
  cv::Mat image(rows, columns, CV_8U);
  cv::RNG random(7);
  random.fill(image, cv::RNG::UNIFORM, 0, 256);
  return image;
}

TEST(BlurredPart, IsTheBinomialKernelUnrounded) {
  const cv::Mat image = noiseImage(40, 50);
  const BlurredImage blurred = blurredPart(image, {-5, 7, 30, 60});
  EXPECT_EQ(blurred.origin, cv::Point(2, 7));
  const int kernel[5] = {1, 4, 6, 4, 1};
  for (int y = 0; y < blurred.pixels.rows; ++y)
    for (int x = 0; x < blurred.pixels.cols; ++x) {
      int sum = 0;
      for (int v = 0; v < 5; ++v)
        for (int u = 0; u < 5; ++u)
          sum += kernel[v] * kernel[u] *
                 image.at<uchar>(blurred.origin.y + y + v - 2, blurred.origin.x + x + u - 2);
      ASSERT_EQ(int(blurred.pixels(y, x)), sum);
    }
}

TEST(BlurredPart, OfABoxOutsideTheImageIsEmpty) {
  EXPECT_TRUE(blurredPart(noiseImage(40, 50), {60, 10, 20, 20}).pixels.empty());
}

TEST(ImagePyramid, WithoutItsFinestLevelIsTheSameAbove) {
  const cv::Mat image = noiseImage(61, 83);
  const ImagePyramid whole(image), coarse = ImagePyramid::coarse(image);
  EXPECT_TRUE(coarse.level[0].pixels.empty());
  for (int y = 0; y < whole.level[1].pixels.rows; ++y)
    for (int x = 0; x < whole.level[1].pixels.cols; ++x)
      ASSERT_EQ(whole.level[1].pixels(y, x), whole.level[0].pixels(2 * y, 2 * x)) << x << ' ' << y;
  for (int l = 1; l < kLevels; ++l)
    EXPECT_EQ(cv::norm(whole.level[l].pixels, coarse.level[l].pixels, cv::NORM_INF), 0) << l;
}

TEST(ImagePyramid, OfAPartLiesInTheWhole) {
  const cv::Mat image = noiseImage(160, 200);
  const cv::Point origin(40, 24);
  const ImagePyramid whole(image), part(image(cv::Rect(origin, cv::Size(112, 104))).clone(), origin);
  for (int l = 0; l < kLevels; ++l) {
    const cv::Rect inside(2, 2, part.level[l].pixels.cols - 5, part.level[l].pixels.rows - 5);
    const cv::Rect there = inside + part.level[l].origin;
    EXPECT_EQ(cv::norm(whole.level[l].pixels(there), part.level[l].pixels(inside), cv::NORM_INF), 0) << l;
  }
}

TEST(PatchKernel, BothKernelsGiveTheSameSums) {
  const BlurredImage blurred = blurredPart(noiseImage(60, 80), {0, 0, 80, 60});
  std::vector<float> x, y, z, grey, d_u, d_v;
  for (int i = 0; i < patch::kSamples; ++i) {
    x.push_back(0.7f * float(i % patch::kSide)), y.push_back(0.7f * float(i / patch::kSide)),
        z.push_back(600.f + float(i));
    grey.push_back(float(i) - 31.5f), d_u.push_back(float(i % 7) - 3.f), d_v.push_back(float(i % 5) - 2.f);
  }
  const patch::Samples samples{x.data(), y.data(), z.data(), grey.data(), d_u.data(), d_v.data()};
  const patch::Image image{blurred.pixels.ptr<std::uint16_t>(0),
                           int(blurred.pixels.step1()),
                           blurred.origin.x,
                           blurred.origin.y,
                           blurred.pixels.cols,
                           blurred.pixels.rows};
  const float pose[12] = {1, 0.02f, 0, -0.02f, 1, 0, 0, 0, 1, 3, -2, 20};
  patch::Placement inside, outside;
  inside.d[0] = inside.d[3] = outside.d[0] = outside.d[3] = 800.f;
  inside.offset[0] = 20.3f, inside.offset[1] = 18.6f;
  outside.offset[0] = 74.f, outside.offset[1] = 18.6f;
  const patch::Placement places[2] = {inside, outside};
  patch::Sums base[2], fast[2];
  patch::baseKernel()(image, samples, pose, places, 2, base);
  patch::kernel()(image, samples, pose, places, 2, fast);
  EXPECT_TRUE(base[0].is_inside && fast[0].is_inside);
  EXPECT_FALSE(base[1].is_inside || fast[1].is_inside);
  EXPECT_GT(base[0].i, 1000.f);
  const float close = 2e-5f * base[0].ii;
  EXPECT_NEAR(base[0].i, fast[0].i, close);
  EXPECT_NEAR(base[0].ii, fast[0].ii, close);
  EXPECT_NEAR(base[0].ti, fast[0].ti, close);
  EXPECT_NEAR(base[0].ui, fast[0].ui, close);
  EXPECT_NEAR(base[0].vi, fast[0].vi, close);
}

}  // namespace
}  // namespace facenav::head_tracking
