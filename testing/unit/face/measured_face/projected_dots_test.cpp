// Dots in pictures made by formula: skin with pores, noise and ambient light, dots of any contrast and
// distance.
#include "facenav/measured_face/projected_dots.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

namespace facenav::measured_face {
namespace {

struct Look {
  double dots_grey = 0;  // height of a dot
  int apart_px = 7;
  double noise_grey = 1.5, exposure = 1.0;  // exposure: of the picture with dots, relative to the plain one
  double moved_px = 0;                      // motion between the pictures
  std::uint64_t seed = 1;
  int dot_px = 2;
  double knots_grey = 0;  // height of the bright knots of a cloth that covers all
};

/// Skin: shading, pores of 5 % and a bright shirt without dots below.
cv::Mat skin(double moved_px) {
  cv::RNG random(11);
  cv::Mat pores(480, 640, CV_32F), image(480, 640, CV_32F);
  random.fill(pores, cv::RNG::NORMAL, 0, 1);
  cv::GaussianBlur(pores, pores, {0, 0}, 1.2);
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x)
      image.at<float>(y, x) =
          float((60 + 0.05 * x) * (1 + 0.2 * double(pores.at<float>(y, x))) + (y > 380 ? 80 : 0));
  const cv::Mat shift = (cv::Mat_<double>(2, 3) << 1, 0, moved_px, 0, 1, 0.5 * moved_px);
  cv::warpAffine(image, image, shift, image.size(), cv::INTER_LINEAR, cv::BORDER_REFLECT);
  return image;
}

/// Adds the bright knots of a cloth, about every 7 px.
void addKnots(double height_grey, double moved_px, cv::Mat& image) {
  if (height_grey == 0) return;
  cv::RNG random(5);
  cv::Mat knots = cv::Mat::zeros(image.size(), CV_32F);
  const int shift_px = int(std::lround(moved_px));
  for (int y = 0; y + 7 < image.rows; y += 7)
    for (int x = 0; x + 7 + shift_px < image.cols; x += 7) {
      const cv::Point at(x + random.uniform(0, 5), y + random.uniform(0, 5));
      knots(cv::Rect(at.x + shift_px, at.y, 2, 2)) = height_grey;
    }
  cv::GaussianBlur(knots, knots, {0, 0}, 0.6);
  image += knots;
}

cv::Mat taken(cv::Mat image, double noise_grey, std::uint64_t seed) {
  cv::RNG random(seed);
  cv::Mat noise(image.size(), CV_32F), out;
  random.fill(noise, cv::RNG::NORMAL, 0, noise_grey);
  cv::Mat(image + noise).convertTo(out, CV_8U);
  return out;
}

capture::CapturePair pairOf(const Look& look) {
  cv::RNG random(look.seed);
  cv::Mat dotted = skin(look.moved_px), dots = cv::Mat::zeros(dotted.size(), CV_32F);
  for (int y = 0; y + look.apart_px <= 380; y += look.apart_px)
    for (int x = 0; x + look.apart_px <= dots.cols; x += look.apart_px)
      dots(cv::Rect(x + random.uniform(0, look.apart_px - look.dot_px + 1),
                    y + random.uniform(0, look.apart_px - look.dot_px + 1), look.dot_px, look.dot_px)) =
          look.dots_grey;
  cv::GaussianBlur(dots, dots, {0, 0}, 0.3 * look.dot_px);
  cv::Mat plain = skin(0);
  addKnots(look.knots_grey, look.moved_px, dotted);
  addKnots(look.knots_grey, 0, plain);
  dotted = look.exposure * (dotted + dots);
  const cv::Mat with = taken(dotted, look.noise_grey, look.seed + 100),
                without = taken(plain, look.noise_grey, look.seed + 200);
  return {{with, with}, {without, without}};
}

TEST(ProjectedDots, AreSeenFromSixTimesTheNoiseOnInAnyExposure) {
  for (const double exposure : {0.6, 0.9, 1.3})
    for (const double dots_grey : {10.0, 20.0, 60.0}) {
      const auto pair = pairOf({dots_grey, 7, 1.5, exposure});
      EXPECT_TRUE(showsDots(pair)) << dots_grey << " grey levels, exposure " << exposure;
      EXPECT_FALSE(areDotsSparse(pair)) << dots_grey << " grey levels, exposure " << exposure;
      if (dots_grey < 20) continue;  // a hundred dots of 4 times the noise are too few to tell from chance
      EXPECT_TRUE(areDotsSparse(pairOf({dots_grey, 44, 1.5, exposure})))
          << dots_grey << " grey levels, exposure " << exposure;
    }
}

TEST(ProjectedDots, AreNotSeenWhereThereAreNone) {
  for (const double exposure : {0.3, 1.0, 1.3})
    for (const double moved_px : {0.0, 0.7, 3.0})
      for (const double noise_grey : {0.3, 1.5, 6.0}) {
        const auto pair = pairOf({0, 7, noise_grey, exposure, moved_px, 5});
        EXPECT_FALSE(showsDots(pair))
            << exposure << ", " << moved_px << " px, " << noise_grey << " grey levels";
        EXPECT_FALSE(areDotsSparse(pair));
      }
}

TEST(ProjectedDots, AreSeenInAnySize) {
  for (const int dot_px : {2, 4, 7, 12}) {
    const auto pair = pairOf({40, 7 * dot_px / 2, 1.5, 1.0, 0.0, 1, dot_px});
    EXPECT_TRUE(showsDots(pair)) << dot_px << " px";
  }
}

TEST(ProjectedDots, AreNotTheBrightKnotsOfAClothThatMoved) {
  for (const double moved_px : {2.0, 3.0, 10.0}) {
    const auto pair = pairOf({0, 7, 1.5, 1.0, moved_px, 1, 2, 40.0});
    EXPECT_FALSE(showsDots(pair)) << moved_px << " px";
  }
}

TEST(ProjectedDots, AreSeenInAFaceThatMovedALittle) {
  EXPECT_TRUE(showsDots(pairOf({30, 7, 1.5, 1.0, 1.0})));
}

TEST(ProjectedDots, OnlyCountInTheFace) {
  const auto pair = pairOf({30});
  EXPECT_TRUE(showsDots(pair, cv::Rect(200, 100, 200, 200)));
  EXPECT_FALSE(showsDots(pair, cv::Rect(0, 390, 640, 90))) << "the shirt has none";
  EXPECT_NEAR(findDots(pair, cv::Rect(200, 100, 200, 200)).areaOfOne_px(), 49, 20);
}

TEST(ProjectedDots, NeedTwoPicturesOfOneKind) {
  auto pair = pairOf({30});
  pair.plain.left = cv::Mat();
  EXPECT_FALSE(showsDots(pair));
  pair.plain.left = cv::Mat(10, 10, CV_8U);
  EXPECT_FALSE(showsDots(pair));
}

}  // namespace
}  // namespace facenav::measured_face
