#include "facenav/cameras/picked_spot.h"

#include <gtest/gtest.h>

#include "facenav/core/error.h"
#include "support/stereo_scene.h"

using namespace facenav;
using namespace facenav::cameras;
namespace scenes = facenav::testing;

namespace {

const Eigen::Vector3d kBall_mm(0, 0, 620);
constexpr double kRadius_mm = 90;

bool anywhere(const Point<Camera>&) { return true; }

scenes::SceneOptions rightDarker() {
  scenes::SceneOptions options;
  options.right_gain = 0.8;
  options.right_offset_grey = 12;
  return options;
}

}  // namespace

TEST(PickedSpot, LiesOnTheSurfaceFromEitherPicture) {
  for (const StereoRig& rig : {scenes::convergingRig(), scenes::verticalRig()}) {
    const auto frame = scenes::Scene(scenes::sphere(kBall_mm, kRadius_mm), rightDarker()).render(rig);
    for (const Eigen::Vector3d& offset : {Eigen::Vector3d(5, -10, 0), {-30, 15, 0}, {20, 30, 0}}) {
      const double front_mm = std::sqrt(kRadius_mm * kRadius_mm - offset.squaredNorm());
      const Eigen::Vector3d truth_mm = kBall_mm + offset - Eigen::Vector3d(0, 0, front_mm);
      const Eigen::Vector2d left_px = project(rig.left, truth_mm),
                            right_px = project(rig.right, rig.right_T_left.isometry() * truth_mm);
      const auto from_left = measurePickedSpot(rig, frame, PictureSide::left, left_px, anywhere),
                 from_right = measurePickedSpot(rig, frame, PictureSide::right, right_px, anywhere);
      ASSERT_TRUE(from_left && from_right) << offset.transpose();
      EXPECT_LT((from_left->point.mm - truth_mm).norm(), 0.5);
      EXPECT_LT((from_right->point.mm - truth_mm).norm(), 0.5);
      EXPECT_GT(from_left->sigma_mm, 0.02);
      EXPECT_LT(from_left->sigma_mm, 0.5);
    }
  }
}

TEST(PickedSpot, IsSearchedWhereItMayLieOnly) {
  const StereoRig rig = scenes::convergingRig();
  const auto frame = scenes::Scene(scenes::sphere(kBall_mm, kRadius_mm), {}).render(rig);
  const Eigen::Vector2d px = project(rig.left, {0, 0, kBall_mm.z() - kRadius_mm});
  EXPECT_TRUE(measurePickedSpot(rig, frame, PictureSide::left, px, anywhere));
  EXPECT_FALSE(measurePickedSpot(rig, frame, PictureSide::left, px,
                                 [](const Point<Camera>& place) { return place.mm.z() > 560; }));
}

TEST(PickedSpot, NothingWhereTheSurfaceShowsNoDetail) {
  const StereoRig rig = scenes::convergingRig();
  scenes::SceneOptions plain;
  plain.dots_grey = 0;
  const auto frame = scenes::Scene(scenes::sphere(kBall_mm, kRadius_mm), plain).render(rig);
  const Eigen::Vector2d px = project(rig.left, {0, 0, kBall_mm.z() - kRadius_mm});
  EXPECT_FALSE(measurePickedSpot(rig, frame, PictureSide::left, px, anywhere));
}

TEST(PickedSpot, NothingWhereTwoPlacesLookTheSame) {
  const StereoRig rig = scenes::convergingRig();
  StereoFrame frame;
  frame.left = cv::Mat(rig.height_px, rig.width_px, CV_8U);
  for (int y = 0; y < frame.left.rows; ++y)
    for (int x = 0; x < frame.left.cols; ++x)
      frame.left.at<std::uint8_t>(y, x) = std::uint8_t(128 + 60 * std::sin(x * 0.4) + 40 * std::sin(y * 0.5));
  frame.right = frame.left.clone();
  EXPECT_FALSE(measurePickedSpot(rig, frame, PictureSide::left, {320, 240}, anywhere));
}

TEST(PickedSpot, APixelOutsideThePictureIsRefused) {
  const StereoRig rig = scenes::convergingRig();
  const auto frame = scenes::Scene(scenes::sphere(kBall_mm, kRadius_mm), {}).render(rig);
  EXPECT_THROW(measurePickedSpot(rig, frame, PictureSide::left, {-3, 10}, anywhere), Error);
  EXPECT_THROW(measurePickedSpot(rig, frame, PictureSide::left, {10, double(rig.height_px)}, anywhere),
               Error);
}
