// The sensors' options: noise, exposure, tone, blur, glare, compression.

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "facenav/room/synthetic_source.h"
#include "optics/film.h"
#include "played_scenario.h"

namespace facenav::room {
namespace {

FilmOptions clean() {
  FilmOptions film;
  film.noise_grey = film.blur_px = 0.0;
  return film;
}

cv::Mat flat(double radiance, int side = 64) { return cv::Mat(side, side, CV_32F, cv::Scalar(radiance)); }

double mean(const cv::Mat& image) { return cv::mean(image)[0]; }

TEST(Exposure, ScalesTheLightAndSaturatesAtWhite) {
  FilmOptions film = clean();
  for (const double exposure : {0.5, 1.0, 1.5}) {
    film.exposure = exposure;
    EXPECT_NEAR(mean(develop(flat(0.4), film, 1)), 255 * 0.4 * exposure, 0.51);
  }
  film.exposure = 4.0;
  EXPECT_EQ(mean(develop(flat(0.4), film, 1)), 255.0);
  EXPECT_EQ(mean(develop(flat(-0.1), film, 1)), 0.0);
}

TEST(Gamma, KeepsBlackAndWhite) {
  FilmOptions film = clean();
  for (const double gamma : {0.6, 1.0, 2.2}) {
    film.gamma = gamma;
    EXPECT_EQ(mean(develop(flat(0.0), film, 1)), 0.0);
    EXPECT_EQ(mean(develop(flat(1.0), film, 1)), 255.0);
    EXPECT_NEAR(mean(develop(flat(0.3), film, 1)), 255 * std::pow(0.3, 1 / gamma), 0.51);
  }
}

TEST(Noise, HasItsDeviationAtEachBrightnessAndNoPattern) {
  FilmOptions film = clean();
  for (const double sigma : {1.0, 3.0})
    for (const double radiance : {0.2, 0.8}) {
      film.noise_grey = sigma;
      cv::Mat image;
      develop(flat(radiance, 300), film, 11).convertTo(image, CV_64F);
      cv::Scalar average, deviation;
      cv::meanStdDev(image, average, deviation);
      EXPECT_NEAR(deviation[0], std::sqrt(sigma * sigma + 1.0 / 12), 0.02 * sigma + 0.01);
      image -= average[0];
      const cv::Rect here(0, 0, 299, 300), next(1, 0, 299, 300);
      EXPECT_NEAR(image(here).dot(image(next)) / image.dot(image), 0, 0.015) << "neighbours are independent";
    }
}

TEST(Noise, OfTwoFramesIsIndependent) {
  FilmOptions film = clean();
  film.noise_grey = 3.0;
  cv::Mat a, b;
  develop(flat(0.5, 300), film, 1).convertTo(a, CV_64F);
  develop(flat(0.5, 300), film, 2).convertTo(b, CV_64F);
  a -= mean(a), b -= mean(b);
  EXPECT_NEAR(a.dot(b) / std::sqrt(a.dot(a) * b.dot(b)), 0, 0.015);
}

TEST(Blur, SpreadsAPointByItsVarianceAndKeepsItsLight) {
  FilmOptions film = clean();
  for (const double blur_px : {1.5, 2.5}) {
    film.blur_px = blur_px;
    const double light = 200.0 / 255 * 2 * M_PI * blur_px * blur_px;  // the peak is then at 200
    cv::Mat point = flat(0, 41), image;
    point.at<float>(20, 20) = float(light);
    develop(point, film, 1).convertTo(image, CV_64F);
    double sum = 0, squares = 0, along = 0;
    for (int y = 0; y < 41; ++y)
      for (int x = 0; x < 41; ++x) {
        const double v = image.at<double>(y, x);
        sum += v, along += v * (x - 20), squares += v * (x - 20) * (x - 20);
      }
    EXPECT_NEAR(sum / (255 * light), 1.0, 0.02) << "rounding of the faint rim";
    EXPECT_NEAR(along / sum, 0, 0.01);
    EXPECT_NEAR(std::sqrt(squares / sum), blur_px, 0.08);
  }
}

TEST(Glare, AddsItsMeanAndItsGradient) {
  FilmOptions film = clean();
  film.haze_grey = 60;
  EXPECT_NEAR(mean(develop(flat(0.2), film, 1)), 51 + 60, 1);
  film.haze_right = 0.5, film.haze_down = -0.25;
  const cv::Mat image = develop(flat(0.2, 101), film, 1);
  EXPECT_NEAR(mean(image), 51 + 60, 1.5);
  EXPECT_NEAR(int(image.at<std::uint8_t>(50, 100)) - int(image.at<std::uint8_t>(50, 0)), 60, 2);
  EXPECT_NEAR(int(image.at<std::uint8_t>(100, 50)) - int(image.at<std::uint8_t>(0, 50)), -30, 2);
}

cv::Mat texture() {
  cv::Mat light(96, 96, CV_32F);
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x)
      light.at<float>(y, x) =
          float(0.5 + 0.2 * std::sin(0.9 * x) * std::cos(0.7 * y) + 0.1 * std::sin(0.2 * x));
  return light;
}

TEST(Compression, LosesMoreAtALowerQuality) {
  FilmOptions film = clean();
  const cv::Mat original = develop(texture(), film, 1);
  double before = 0;
  for (const int quality : {95, 70, 40, 10}) {
    film.jpeg_quality = quality;
    const cv::Mat image = develop(texture(), film, 1);
    ASSERT_EQ(image.size(), original.size());
    ASSERT_EQ(image.type(), CV_8U);
    const double loss = cv::norm(image, original, cv::NORM_L2);
    EXPECT_GT(loss, before) << quality;
    before = loss;
  }
  film.jpeg_quality = 0;
  EXPECT_EQ(cv::norm(develop(texture(), film, 1), original, cv::NORM_INF), 0);
}

TEST(Compression, OfAPlainPictureLosesNothing) {
  FilmOptions film = clean();
  film.jpeg_quality = 30;
  EXPECT_NEAR(mean(develop(flat(0.4), film, 1)), 102, 2);
  cv::Scalar average, deviation;
  cv::meanStdDev(develop(flat(0.4), film, 1), average, deviation);
  EXPECT_EQ(deviation[0], 0);
}

TEST(Film, LeavesTheLightItWasGivenAlone) {
  const cv::Mat light = texture(), copy = light.clone();
  FilmOptions film;
  film.exposure = 2, film.gamma = 1.8, film.haze_grey = 20;
  develop(light, film, 5);
  film.blur_px = 0;
  develop(light, film, 5);
  EXPECT_EQ(cv::norm(light, copy, cv::NORM_INF), 0);
}

/// Mean grey of both pictures of one frame.
std::pair<double, double> greys(const ScenarioOptions& options) {
  SyntheticSource source(options, testing::eggPatient());
  const auto frame = source.next();
  return {mean(frame->left), mean(frame->right)};
}

TEST(RightCamera, TakesMoreLightByItsGainAndTheLeftOneDoesNot) {
  auto options = testing::smallScenario("still", 1);
  options.exposure = 0.6, options.noise_grey = 0.0;
  const auto even = greys(options);
  options.right_gain = 1.3;
  const auto brighter = greys(options);
  EXPECT_EQ(brighter.first, even.first);
  EXPECT_NEAR(brighter.second / even.second, 1.3, 0.03);
  options.right_gain = 1.0, options.right_gamma = 1.5;
  const auto toned = greys(options);
  EXPECT_EQ(toned.first, even.first);
  EXPECT_GT(toned.second, even.second + 5) << "a larger gamma lifts the dark";
}

TEST(RightCamera, ExposedLateSeesTheHeadLaterAndTheTruthIsTheLefts) {
  auto options = testing::smallScenario("free_motion", 30);
  options.noise_grey = 0.0;
  auto late = options;
  late.right_late_ms = 30;
  const auto a = testing::playedToEnd(options), b = testing::playedToEnd(late);
  ASSERT_EQ(a.frames.size(), b.frames.size());
  for (const std::size_t frame : {10u, 25u}) {
    EXPECT_EQ(cv::norm(a.frames[frame].left, b.frames[frame].left, cv::NORM_INF), 0);
    EXPECT_GT(cv::norm(a.frames[frame].right, b.frames[frame].right, cv::NORM_INF), 10);
    EXPECT_EQ(a.truths[frame].camera_T_mri.matrix(), b.truths[frame].camera_T_mri.matrix());
  }
}

ScenarioOptions quiet(const char* name, int frames) {
  ScenarioOptions options = testing::smallScenario(name, frames);
  options.noise_grey = 0.0, options.jpeg_quality = 0, options.gloss = 0.0;
  return options;
}

TEST(RollingShutter, LaterRowsSeeLaterMomentsAndTheMiddleRowSeesTheTruth) {
  ScenarioOptions options = quiet("free_motion", 12);
  options.frames_per_s = 10.0;
  const auto global = testing::playedToEnd(options);
  options.rolling_ms = 90.0;
  const auto rolling = testing::playedToEnd(options);
  ASSERT_EQ(rolling.frames.size(), global.frames.size());
  double top_by_earlier = 0, bottom_by_later = 0, middle_by_now = 0;
  for (std::size_t i = 4; i < 11; ++i) {
    const auto off = [&](std::size_t frame, const cv::Range& rows) {
      return cv::norm(rolling.frames[i].left.rowRange(rows), global.frames[frame].left.rowRange(rows),
                      cv::NORM_L1);
    };
    const cv::Range top(40, 46), middle(57, 63), bottom(94, 100);  // all of them show the head
    top_by_earlier += off(i + 1, top) - off(i - 1, top);
    bottom_by_later += off(i - 1, bottom) - off(i + 1, bottom);
    middle_by_now += std::min(off(i - 1, middle), off(i + 1, middle)) - off(i, middle);
  }
  EXPECT_GT(top_by_earlier, 0.0) << "rows above see what was";
  EXPECT_GT(bottom_by_later, 0.0) << "rows below see what comes";
  EXPECT_GT(middle_by_now, 0.0);
}

TEST(ExposureBlur, AStillSceneIsNotBlurred) {
  ScenarioOptions options = quiet("still", 1);
  const auto sharp = testing::playedToEnd(options);
  options.exposure_ms = 30.0, options.rolling_ms = 20.0;
  const auto swept = testing::playedToEnd(options);
  EXPECT_LE(cv::norm(sharp.frames[0].left, swept.frames[0].left, cv::NORM_INF), 1.0);
  EXPECT_LE(cv::norm(sharp.frames[0].right, swept.frames[0].right, cv::NORM_INF), 1.0);
}

TEST(AutomaticExposure, GoesUpAndDownByItsStep) {
  ScenarioOptions options = quiet("still", 60);
  options.frames_per_s = 30.0, options.exposure_step = 0.3, options.exposure = 0.8;
  const auto played = testing::playedToEnd(options);
  const double first = mean(played.frames[0].left), up = mean(played.frames[30].left),
               down = mean(played.frames[55].left);
  EXPECT_NEAR(up / first, 1.3, 0.03);
  EXPECT_NEAR(down / first, 1.0, 0.01);
}

TEST(LostFocus, BlursTheMiddleOfTheRecordingOnly) {
  ScenarioOptions options = quiet("still", 13);
  options.refocus_px = 1.5;
  const auto detail = [](const cv::Mat& image) {
    cv::Mat edges;
    cv::Laplacian(image, edges, CV_32F);
    return cv::norm(edges, cv::NORM_L2);
  };
  const auto played = testing::playedToEnd(options);
  EXPECT_LT(detail(played.frames[6].left), 0.6 * detail(played.frames[0].left));
  EXPECT_NEAR(detail(played.frames[12].left), detail(played.frames[0].left), 1e-3);
}

TEST(LostPairs, AreMissingAndDoubledOnesRepeatTheLastWithItsTruth) {
  ScenarioOptions options = quiet("free_motion", 60);
  options.dropped = 0.2, options.doubled = 0.2;
  const auto played = testing::playedToEnd(options);
  EXPECT_LT(played.frames.size(), 58u);
  EXPECT_GT(played.frames.size(), 36u);
  int doubled = 0;
  for (std::size_t i = 1; i < played.frames.size(); ++i) {
    EXPECT_GT(played.frames[i].number, played.frames[i - 1].number);
    EXPECT_EQ(played.truths[i].frame, played.frames[i].number);
    if (cv::norm(played.frames[i].left, played.frames[i - 1].left, cv::NORM_INF) > 0) continue;
    ++doubled;
    EXPECT_EQ(played.truths[i].camera_T_mri.matrix(), played.truths[i - 1].camera_T_mri.matrix());
  }
  EXPECT_GT(doubled, 3);
}

TEST(DriftingClock, TheDelayGrowsAndTheDriverStatesIt) {
  ScenarioOptions options = quiet("still", 31);
  options.frames_per_s = 30.0, options.right_late_ms = 9.0, options.clock_ppm = 1000.0;
  EXPECT_FALSE(testing::playedToEnd(options).frames[0].right_late_s);
  options.right_time_stamps = 1;
  const auto played = testing::playedToEnd(options);
  EXPECT_NEAR(played.frames.front().right_late_s.value(), 0.009, 1e-9);
  EXPECT_NEAR(played.frames.back().right_late_s.value(), 0.010, 1e-9);
}

}  // namespace
}  // namespace facenav::room
