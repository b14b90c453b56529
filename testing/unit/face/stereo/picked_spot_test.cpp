#include "facenav/stereo/picked_spot.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "facenav/core/error.h"
#include "support/stereo_scene.h"
#include "support/test_data.h"

using namespace facenav;
using namespace facenav::cameras;
using namespace facenav::stereo;
namespace scenes = facenav::testing;

namespace {

const Eigen::Vector3d kSpotBall_mm(0, 0, 620);
constexpr double kSpotRadius_mm = 90;

constexpr int kEvery_px = 45;

bool anywhere(const Point<Camera>&) { return true; }
bool nearFace(const Point<Camera>& place) { return place.mm.z() > 480 && place.mm.z() < 620; }

/// Measures a spot; returns nothing also if there is too little to measure.
std::optional<PickedSpot> spotOrNothing(const StereoRig& rig, const StereoFrame& frame, PictureSide side,
                                        const Eigen::Vector2d& px,
                                        const std::function<bool(const Point<Camera>&)>& mayLie) {
  try {
    return measurePickedSpot(rig, frame, side, px, mayLie);
  } catch (const Error&) {
    return std::nullopt;
  }
}

scenes::SceneOptions rightDarker() {
  scenes::SceneOptions options;
  options.right_gain = 0.8;
  options.right_offset_grey = 12;
  return options;
}

}  // namespace

TEST(PickedSpot, LiesOnTheSurfaceFromEitherPicture) {
  for (const StereoRig& rig : {scenes::convergingRig(), scenes::verticalRig()}) {
    const auto frame = scenes::Scene(scenes::sphere(kSpotBall_mm, kSpotRadius_mm), rightDarker()).render(rig);
    for (const Eigen::Vector3d& offset : {Eigen::Vector3d(5, -10, 0), {-30, 15, 0}, {20, 30, 0}}) {
      const double front_mm = std::sqrt(kSpotRadius_mm * kSpotRadius_mm - offset.squaredNorm());
      const Eigen::Vector3d truth_mm = kSpotBall_mm + offset - Eigen::Vector3d(0, 0, front_mm);
      const Eigen::Vector2d left_px = project(rig.left, truth_mm),
                            right_px = project(rig.right, rig.right_T_left.isometry() * truth_mm);
      const auto from_left = measurePickedSpot(rig, frame, PictureSide::left, left_px, anywhere),
                 from_right = measurePickedSpot(rig, frame, PictureSide::right, right_px, anywhere);
      ASSERT_TRUE(from_left && from_right) << offset.transpose();
      EXPECT_LT((from_left->point.mm - truth_mm).norm(), 0.5);
      EXPECT_LT((from_right->point.mm - truth_mm).norm(), 0.5);
      // The given error is that of plain skin, independent of the dots on this ball.
      const double depth_mm = truth_mm.z(), skin_mm = kPlainSkinError_px * depth_mm * depth_mm /
                                                      (rig.left.k(0, 0) * rig.baseline_mm());
      EXPECT_GT(from_left->sigma_mm, skin_mm);
      EXPECT_LT(from_left->sigma_mm, 2.5 * skin_mm);
    }
  }
}

TEST(PickedSpot, IsSearchedWhereItMayLieOnly) {
  const StereoRig rig = scenes::convergingRig();
  const auto frame = scenes::Scene(scenes::sphere(kSpotBall_mm, kSpotRadius_mm), {}).render(rig);
  const Eigen::Vector2d px = project(rig.left, {0, 0, kSpotBall_mm.z() - kSpotRadius_mm});
  EXPECT_TRUE(measurePickedSpot(rig, frame, PictureSide::left, px, anywhere));
  EXPECT_FALSE(spotOrNothing(rig, frame, PictureSide::left, px,
                             [](const Point<Camera>& place) { return place.mm.z() > 560; }));
}

TEST(PickedSpot, NothingWhereTheSurfaceShowsNoDetail) {
  const StereoRig rig = scenes::convergingRig();
  scenes::SceneOptions plain;
  plain.dots_grey = 0;
  const auto frame = scenes::Scene(scenes::sphere(kSpotBall_mm, kSpotRadius_mm), plain).render(rig);
  const Eigen::Vector2d px = project(rig.left, {0, 0, kSpotBall_mm.z() - kSpotRadius_mm});
  EXPECT_FALSE(spotOrNothing(rig, frame, PictureSide::left, px, anywhere));
}

TEST(PickedSpot, NothingWhereTwoPlacesLookTheSame) {
  const StereoRig rig = scenes::convergingRig();
  StereoFrame frame;
  frame.left = cv::Mat(rig.height_px, rig.width_px, CV_8U);
  for (int y = 0; y < frame.left.rows; ++y)
    for (int x = 0; x < frame.left.cols; ++x)
      frame.left.at<std::uint8_t>(y, x) = std::uint8_t(128 + 60 * std::sin(x * 0.4) + 40 * std::sin(y * 0.5));
  frame.right = frame.left.clone();
  EXPECT_FALSE(spotOrNothing(rig, frame, PictureSide::left, {320, 240}, anywhere));
}

TEST(PickedSpot, APixelOutsideThePictureIsRefused) {
  const StereoRig rig = scenes::convergingRig();
  const auto frame = scenes::Scene(scenes::sphere(kSpotBall_mm, kSpotRadius_mm), {}).render(rig);
  EXPECT_THROW(measurePickedSpot(rig, frame, PictureSide::left, {-3, 10}, anywhere), Error);
  EXPECT_THROW(measurePickedSpot(rig, frame, PictureSide::left, {10, double(rig.height_px)}, anywhere),
               Error);
}

/// A real person before three cameras (../shared/data/real_faces): spots of the middle picture, measured with
/// the left camera and with the right one, coincide. The moments differ from those that the limits were
/// chosen on; the person is the same.
TEST(PickedSpot, OfAPhotographIsOnePlaceWhicheverCameraMeasuresIt) {
  const auto folder = scenes::sharedData() / "real_faces";
  FACENAV_NEEDS(folder / "mr_stereo.yml");
  const StereoRig lm = readRig(folder / "lm_stereo.yml"), mr = readRig(folder / "mr_stereo.yml");
  std::vector<double> apart_mm, in_sigmas;
  int asked = 0;
  for (const char* moment : {"835", "1252", "1669"}) {
    const auto picture = [&](const char* camera) {
      return cv::imread(folder / "person" / (std::string(camera) + "_" + moment + ".jpg"),
                        cv::IMREAD_GRAYSCALE);
    };
    StereoFrame with_left, with_right;
    with_left.left = picture("l");
    with_left.right = with_right.left = picture("m");
    with_right.right = picture("r");
    for (int y = 300; y <= 700; y += kEvery_px)
      for (int x = 350; x <= 700; x += kEvery_px) {
        ++asked;
        const auto a = spotOrNothing(lm, with_left, PictureSide::right, {x, y}, nearFace),
                   b = spotOrNothing(mr, with_right, PictureSide::left, {x, y}, nearFace);
        if (!a || !b) continue;
        apart_mm.push_back((lm.right_T_left.isometry() * a->point.mm - b->point.mm).norm());
        in_sigmas.push_back(apart_mm.back() / std::hypot(a->sigma_mm, b->sigma_mm));
      }
  }
  ASSERT_GT(apart_mm.size(), std::size_t(asked / 5));
  std::sort(apart_mm.begin(), apart_mm.end());
  std::sort(in_sigmas.begin(), in_sigmas.end());
  std::printf("%zu of %d spots: median %.2f, p90 %.2f, most %.2f mm; p68 %.2f, p90 %.2f sigma\n",
              apart_mm.size(), asked, apart_mm[apart_mm.size() / 2], apart_mm[apart_mm.size() * 9 / 10],
              apart_mm.back(), in_sigmas[in_sigmas.size() * 68 / 100], in_sigmas[in_sigmas.size() * 9 / 10]);
  EXPECT_LT(apart_mm[apart_mm.size() / 2], 1.5);
  EXPECT_LT(in_sigmas[in_sigmas.size() * 9 / 10], 2.5);
}
