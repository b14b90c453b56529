#include "facenav/stereo/rectification.h"

#include <gmock/gmock.h>

#include "facenav/core/error.h"
#include "support/matchers.h"
#include "support/stereo_rigs.h"

using namespace facenav;
using namespace facenav::stereo;
using facenav::testing::EigenNear;
namespace support = facenav::testing;

namespace {

cameras::StereoRig swappedRig() {
  cameras::StereoRig rig = support::convergingRig();
  std::swap(rig.left, rig.right);
  rig.right_T_left =
      rig.right_T_left.inverse().reframe<RightCamera, Camera>();  // names changed with the cameras
  return rig;
}

// The rectified pixel whose map entry lies nearest to a recorded pixel, refined by the map's local slope.
Eigen::Vector2d rectifiedPixel(const cv::Mat& map, const Eigen::Vector2d& recorded) {
  Eigen::Vector2d at(map.cols / 2.0, map.rows / 2.0);
  for (int iteration = 0; iteration < 30; ++iteration) {
    const int x = std::clamp(int(std::lround(at.x())), 1, map.cols - 2);
    const int y = std::clamp(int(std::lround(at.y())), 1, map.rows - 2);
    const auto value = [&](int i, int j) {
      const cv::Vec2f v = map.at<cv::Vec2f>(j, i);
      return Eigen::Vector2d(v[0], v[1]);
    };
    Eigen::Matrix2d slope;
    slope << 0.5 * (value(x + 1, y) - value(x - 1, y)), 0.5 * (value(x, y + 1) - value(x, y - 1));
    at = Eigen::Vector2d(x, y) + slope.inverse() * (recorded - value(x, y));
  }
  return at;
}

}  // namespace

TEST(Rectification, PutsMatchesOnOneRowWhateverTheRelativePose) {
  for (const cameras::StereoRig& rig :
       {support::convergingRig(), support::verticalRig(), support::rolledRig(), swappedRig()}) {
    const Rectification r = rectify(rig, {400, 1000});
    for (const Eigen::Vector3d& p : {Eigen::Vector3d(10, 20, 600), {-60, 30, 620}, {50, -60, 700}}) {
      const Eigen::Vector2d left = rectifiedPixel(r.left_map, project(rig.left, p));
      const Eigen::Vector2d right =
          rectifiedPixel(r.right_map, project(rig.right, rig.right_T_left.isometry() * p));
      EXPECT_NEAR(left.y(), right.y(), 0.01);
      const double disparity = left.x() - (right.x() - r.disparities);
      EXPECT_GT(disparity, 0);
      EXPECT_LT(disparity, r.disparities - 1);
      EXPECT_THAT(r.point_mm(left.x(), left.y(), disparity), EigenNear(p, 0.06));  // 0.01 px of depth
    }
  }
}

TEST(Rectification, DepthPerDisparityIsTheDerivative) {
  const Rectification r = rectify(support::convergingRig(), {400, 1000});
  const auto depth = [&](double d) { return (r.rectified_R_camera * r.point_mm(300, 200, d)).z(); };
  EXPECT_NEAR(r.depthPerDisparity_mm(60), (depth(60.001) - depth(59.999)) / 0.002, 1e-6);
}

TEST(Rectification, RegionOfInterestIsAllThatIsSearched) {
  const cameras::StereoRig rig = support::convergingRig();
  const Rectification whole = rectify(rig, {400, 1000}),
                      part = rectify(rig, {400, 1000}, {200, 150, 160, 120});
  EXPECT_LT(part.left_map.total(), whole.left_map.total() / 6);
  for (int y = 0; y < part.left_map.rows; ++y)
    for (int x = 0; x < part.left_map.cols; ++x)
      if (part.left_mask.at<std::uint8_t>(y, x)) {
        const cv::Vec2f p = part.left_map.at<cv::Vec2f>(y, x);
        ASSERT_TRUE(p[0] >= 200 && p[0] <= 359 && p[1] >= 150 && p[1] <= 269);
      }
  EXPECT_THROW(rectify(rig, {400, 1000}, {900, 900, 50, 50}), Error);
}

TEST(Rectification, RefusesCamerasInOneLineOrFacingApart) {
  cameras::StereoRig rig = support::convergingRig();
  rig.right_T_left = {Eigen::Quaterniond::Identity(), {0, 0, -120}};
  EXPECT_THROW(rectify(rig, {400, 1000}), Error);
  rig.right_T_left = {Eigen::Quaterniond(expRotation({0, 2.6, 0})), {-120, 0, 0}};
  EXPECT_THROW(rectify(rig, {400, 1000}), Error);
}
