// The room's imitation of a real face in front of near colour cameras: rig, sensors, scenario.
#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <set>

#include "facenav/core/error.h"
#include "optics/film.h"
#include "played_scenario.h"
#include "script/script.h"
#include "support/matchers.h"

namespace facenav::room {
namespace {

ScenarioOptions named(const char* name) {
  ScenarioOptions options;
  options.name = name;
  return options;
}

TEST(CloseRig, HasTheStatedGeometry) {
  auto options = named("still");
  options.rig_name = "close";
  const auto played = resolved(options);
  const auto rig = makeRig(played.rig);
  EXPECT_EQ(rig.width_px, 1024);
  EXPECT_EQ(rig.height_px, 1024);
  EXPECT_NEAR(rig.left.k(0, 0), 1550.0, 1e-9);
  EXPECT_NEAR(rig.right.k(0, 0), 1550.0, 15.5) << "the cameras differ by less than 1 %";
  EXPECT_NEAR(rig.baseline_mm(), 114.0, 1e-9);
  const Eigen::Vector3d right_axis = rig.right_T_left.inverse().rotation().col(2);
  EXPECT_NEAR(std::acos(right_axis.z()) * 180.0 / M_PI, 20.0, 0.1);
  const auto patient = testing::eggPatient();
  EXPECT_NEAR((seatedHead(played, *patient) * patient->face_middle).mm.z(), 560.0, 8.0);
}

TEST(CloseRig, LeavesWhatWasAskedForAndIsNotTheDefault) {
  auto options = named("still");
  EXPECT_EQ(resolved(options).rig.width_px, 640);
  options.rig_name = "close";
  options.rig.focal_px = 1200.0;
  EXPECT_EQ(resolved(options).rig.focal_px, 1200.0);
  EXPECT_EQ(resolved(options).rig.width_px, 1024);
  options.rig_name = "clsoe";
  EXPECT_THROW(resolved(options), Error);
}

/// A picture with soft structure: its grey and its redness.
std::pair<cv::Mat, cv::Mat> softPicture() {
  cv::Mat grey(64, 96, CV_32F), red(64, 96, CV_32F);
  for (int y = 0; y < grey.rows; ++y)
    for (int x = 0; x < grey.cols; ++x) {
      grey.at<float>(y, x) = float(0.4 + 0.1 * std::sin(0.2 * x) + 0.05 * std::cos(0.15 * y));
      red.at<float>(y, x) = 0.3f * grey.at<float>(y, x);
    }
  return {grey, red};
}

TEST(Film, AMosaicOfEqualSharesKeepsTheMeanBrightness) {
  const auto [grey, red] = softPicture();
  FilmOptions film;
  film.noise_grey = 0.0;
  const cv::Mat plain = develop(grey, film, 1);
  EXPECT_EQ(cv::norm(plain, develop(grey, film, 1, red), cv::NORM_INF), 0.0) << "equal shares see no colour";
  film.is_bayer = true;
  const cv::Mat mosaic = develop(grey, film, 1, red);
  EXPECT_NEAR(cv::mean(mosaic)[0], cv::mean(plain)[0], 1.0);
  film.jpeg_quality = 35;
  EXPECT_NEAR(cv::mean(develop(grey, film, 1, red))[0], cv::mean(plain)[0], 1.5);
}

TEST(Film, SharesWeighRedGreenAndBlue) {
  const cv::Mat grey(32, 32, CV_32F, cv::Scalar(0.4)), red(32, 32, CV_32F, cv::Scalar(0.1));
  FilmOptions film;
  film.noise_grey = 0.0;
  for (const bool is_bayer : {false, true}) {
    film.is_bayer = is_bayer;
    film.red_share = 1.0, film.blue_share = 0.0;
    EXPECT_NEAR(cv::mean(develop(grey, film, 1, red))[0], 0.5 * 255.0, 1.0) << is_bayer;
    film.red_share = 0.0, film.blue_share = 1.0;
    EXPECT_NEAR(cv::mean(develop(grey, film, 1, red))[0], 0.3 * 255.0, 1.0) << is_bayer;
    film.red_share = 0.3, film.blue_share = 0.1;
    EXPECT_NEAR(cv::mean(develop(grey, film, 1, red))[0], 0.42 * 255.0, 1.0) << is_bayer;
  }
}

ScenarioOptions small(const char* name, std::uint64_t seed = 1) {
  auto options = testing::smallScenario(name);
  options.seed = seed;
  options.rig_name = "room";
  return options;
}

TEST(Moments, BringCamerasLightAndSkinOfTheirOwnUnlessAskedFor) {
  auto options = named("moments");
  options.haze_grey = 30.0;
  const auto played = resolved(options);
  EXPECT_EQ(played.rig.focal_px, 1550.0);
  EXPECT_EQ(played.head_distance_mm, 560.0);
  EXPECT_EQ(played.jpeg_quality, 35);
  EXPECT_EQ(played.haze_grey, 30.0);
  EXPECT_EQ(played.skin_contrast, 0.12);
  EXPECT_EQ(played.blinks, 1);
  EXPECT_EQ(played.bayer, 1);
  EXPECT_GT(played.hair_sway_mm, 0.0);
  EXPECT_EQ(resolved(named("treatment")).blinks, 0);
  EXPECT_EQ(resolved(named("treatment")).hair_sway_mm, 0.0);
}

TEST(Moments, AreFiveSomeSecondsApartWithOtherFacesPlacesAndHair) {
  const auto patient = testing::eggPatient();
  for (const std::uint64_t seed : {1u, 2u, 9u}) {
    const auto script = makeScript(small("moments", seed), *patient, leftHandArea(*patient), {});
    std::set<std::string> labels;
    std::set<std::uint64_t> hair;
    double seen_s = 0.0;
    const auto seat = script->at(0).cast.room_T_mri;
    for (int frame = 0; frame < script->frameCount(); ++frame) {
      const Moment now = script->at(frame);
      if (now.label == "away") continue;
      const double t_s = frame / 60.0 + now.later_s;
      if (!labels.insert(now.label).second) {
        EXPECT_LT(t_s - seen_s, 0.05);
      } else if (frame > 0) {
        EXPECT_GT(t_s - seen_s, 1.0);
        EXPECT_LT(t_s - seen_s, 5.0);
        const Eigen::Isometry3d moved = now.cast.room_T_mri.isometry() * seat.isometry().inverse();
        EXPECT_GT(rotationAngle(moved.linear()) * 180.0 / M_PI, 0.1);  // 0.5-5 deg, plus a little sway
        EXPECT_LT(rotationAngle(moved.linear()) * 180.0 / M_PI, 6.5);
      }
      hair.insert(now.cast.hair.pattern);
      seen_s = t_s;
    }
    EXPECT_EQ(labels.size(), 5u) << seed;
    EXPECT_EQ(hair.size(), 5u) << seed;
  }
}

TEST(Moments, AreTheSameForTheSameSeedAndTheHeadIsAwayInBetween) {
  auto options = small("moments", 3);
  options.frames = 20;
  const auto a = testing::playedToEnd(options), b = testing::playedToEnd(options);
  for (const std::size_t frame : {std::size_t(0), std::size_t(19)}) {
    EXPECT_EQ(cv::norm(a.frames[frame].left, b.frames[frame].left, cv::NORM_INF), 0.0);
    EXPECT_EQ(cv::norm(a.frames[frame].right, b.frames[frame].right, cv::NORM_INF), 0.0);
  }
  for (std::size_t i = 0; i < a.truths.size(); ++i) {
    EXPECT_EQ(a.truths[i].must_be_lost, i == 15 || i == 16) << i;
    EXPECT_TRUE(a.truths[i].is_patient_there);
  }
  options.seed = 4;
  EXPECT_GT(cv::norm(a.frames[19].left, testing::playedToEnd(options).frames[19].left, cv::NORM_INF), 0.0);
}

TEST(MomentsOther, PutsAnotherPersonThereAtTheThirdAndFourthMoment) {
  const auto patient = testing::eggPatient();
  const auto script = makeScript(small("moments_other"), *patient, leftHandArea(*patient), {});
  for (int frame = 0; frame < script->frameCount(); ++frame)
    EXPECT_EQ(script->at(frame).cast.stranger != 0, frame >= 32 && frame < 66) << frame;
}

}  // namespace
}  // namespace facenav::room
