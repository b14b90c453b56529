#include <gtest/gtest.h>

#include <cmath>

#include "facenav/room/room_rig.h"
#include "optics/film.h"
#include "optics/renderer.h"
#include "optics/shapes.h"

namespace facenav::room {
namespace {

RigOptions bentRig() {
  RigOptions options;
  options.k1 = -0.3;
  options.k2 = 0.15;
  options.roll_deg = 8.0;
  return options;
}

TEST(RoomRig, HasTheBaselineAndConvergenceAskedFor) {
  RigOptions options;
  options.baseline_mm = 150.0;
  const auto rig = makeRig(options);
  EXPECT_NEAR(rig.baseline_mm(), 150.0, 1e-9);
  const Eigen::Vector3d right_axis = rig.right_T_left.inverse().rotation().col(2);
  EXPECT_NEAR(std::acos(right_axis.z()) * 180.0 / M_PI, 10.0, 0.1);
  EXPECT_LT(right_axis.x(), 0.0) << "the cameras look towards each other";
  const Eigen::Vector3d ahead =
      (cameraFromRoom(rig) * Point<Room>(0.0, 0.0, 75.0 / std::tan(5.0 * M_PI / 180.0))).mm;
  EXPECT_NEAR(ahead.x() / ahead.z(), 0.0, 0.01) << "both axes meet in front of the rig's middle";
}

TEST(CameraRays, ProjectBackOntoThePixelTheyCameFrom) {
  const auto rig = makeRig(bentRig());
  const CameraRays rays(rig.right, rig.width_px, rig.height_px, rig.right_T_left.isometry());
  double worst_px = 0.0;
  for (double y = 0.3; y < rig.height_px - 1; y += 17.31)
    for (double x = 0.4; x < rig.width_px - 1; x += 13.77) {
      const Eigen::Vector3d p_world = rays.origin_mm() + 700.0 * rays.direction(x, y);
      const auto pixel = cameras::project(rig.right, rig.right_T_left.isometry() * p_world);
      worst_px = std::max(worst_px, (pixel - Eigen::Vector2d(x, y)).norm());
    }
  EXPECT_LT(worst_px, 1e-3);
}

TEST(Renderer, DepthOfASphereIsExactInBothCameras) {
  const auto rig = makeRig(bentRig());
  const Eigen::Vector3d centre_mm(40.0, -20.0, 640.0);
  const double radius_mm = 90.0;
  RayScene scene;
  scene.add(ellipsoid({0, 0, 0}, Eigen::Vector3d::Constant(radius_mm), 400));
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = centre_mm;
  scene.setPose(0, pose);
  scene.commit();
  for (const bool is_right : {false, true}) {
    const Eigen::Isometry3d camera_T_world =
        is_right ? rig.right_T_left.isometry() : Eigen::Isometry3d::Identity();
    const CameraRays rays(is_right ? rig.right : rig.left, rig.width_px, rig.height_px, camera_T_world);
    const Renderer renderer(rays, cv::Mat::zeros(rig.height_px, rig.width_px, CV_32F));
    const View view = renderer.render(scene, {makePlainLook(0.5f, 0.f)}, {});
    double worst_mm = 0.0;
    int pixels = 0;
    for (int y = 0; y < rig.height_px; ++y)
      for (int x = 0; x < rig.width_px; ++x) {
        const Eigen::Vector2d ray = cameras::undistort(rays.camera(), {double(x), double(y)});
        const Eigen::Vector3d along = ray.homogeneous(), centre = camera_T_world * centre_mm;
        const double a = along.squaredNorm(), b = along.dot(centre),
                     c = centre.squaredNorm() - radius_mm * radius_mm;
        if (b * b - a * c < 0.25 * a * radius_mm * radius_mm) continue;  // grazing: facets dominate
        worst_mm =
            std::max(worst_mm, std::abs(view.depth_mm.at<float>(y, x) - (b - std::sqrt(b * b - a * c)) / a));
        ++pixels;
      }
    EXPECT_GT(pixels, 20000);
    EXPECT_LT(worst_mm, 0.01);
  }
}

TEST(Film, NoiseHasTheDeviationAskedFor) {
  FilmOptions film;
  film.noise_grey = 1.5;
  const cv::Mat grey = develop(cv::Mat(400, 400, CV_32F, cv::Scalar(0.5)), film, 7);
  cv::Scalar mean, deviation;
  cv::meanStdDev(grey, mean, deviation);
  EXPECT_NEAR(mean[0], 127.5, 0.05);
  EXPECT_NEAR(deviation[0], std::sqrt(1.5 * 1.5 + 1.0 / 12.0), 0.02);  // rounding to grey levels adds 1/12
}

TEST(Film, SameSeedSameNoise) {
  const cv::Mat flat(50, 60, CV_32F, cv::Scalar(0.4));
  EXPECT_EQ(cv::norm(develop(flat, {}, 3), develop(flat, {}, 3), cv::NORM_INF), 0.0);
  EXPECT_GT(cv::norm(develop(flat, {}, 3), develop(flat, {}, 4), cv::NORM_INF), 0.0);
}

TEST(Film, GammaBrightensTheMiddle) {
  FilmOptions film{0.0, 1.0, 2.2, 0.0};
  const cv::Mat grey = develop(cv::Mat(4, 4, CV_32F, cv::Scalar(0.25)), film, 1);
  EXPECT_EQ(int(grey.at<std::uint8_t>(2, 2)), int(std::lround(255.0 * std::pow(0.25, 1.0 / 2.2))));
}

}  // namespace
}  // namespace facenav::room
