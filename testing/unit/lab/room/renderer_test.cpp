// The room's pictures and their truth: position of a known point, occlusion, light and shadow.

#include "optics/renderer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "facenav/room/room_rig.h"
#include "optics/noise_field.h"
#include "optics/shapes.h"
#include "support/matchers.h"

namespace facenav::room {
namespace {

using testing::EigenNear;

RigOptions smallOptions() {
  RigOptions options;
  options.width_px = 320;
  options.height_px = 240;
  options.focal_px = 400;
  return options;
}

/// Constant reflectance without grain.
class Matt : public Look {
 public:
  explicit Matt(float albedo) : albedo_(albedo) {}
  Reflectance at(const SurfacePoint&) const override { return {albedo_, 0.f}; }

 private:
  float albedo_;
};

struct Studio {
  cameras::StereoRig rig = makeRig(smallOptions());
  CameraRays left{rig.left, rig.width_px, rig.height_px, Eigen::Isometry3d::Identity()},
      right{rig.right, rig.width_px, rig.height_px, rig.right_T_left.isometry()};
  RayScene scene;
  std::vector<std::shared_ptr<const Look>> looks;
  Lighting lighting;

  int add(const surface::TriangleMesh& mesh, float albedo = 0.5f) {
    looks.push_back(std::make_shared<Matt>(albedo));
    return scene.add(mesh);
  }
  View render(const CameraRays& rays, float backdrop = 0.f) {
    scene.commit();
    return Renderer(rays, cv::Mat(rig.height_px, rig.width_px, CV_32F, cv::Scalar(backdrop)))
        .render(scene, looks, lighting);
  }
};

Eigen::Vector2d centroid(const cv::Mat& object, int number) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  int count = 0;
  for (int y = 0; y < object.rows; ++y)
    for (int x = 0; x < object.cols; ++x)
      if (object.at<std::uint8_t>(y, x) == number) sum += Eigen::Vector2d(x, y), ++count;
  return count ? Eigen::Vector2d(sum / count) : Eigen::Vector2d(-1, -1);
}

TEST(Renderer, ASmallBallAppearsWhereTheCamerasProjectIt) {
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(0, 0, 600), {70, -40, 620}, {-80, 60, 700}}) {
    Studio studio;
    studio.add(ellipsoid(p, Eigen::Vector3d::Constant(8), 32));
    const View left = studio.render(studio.left), right = studio.render(studio.right);
    EXPECT_THAT(centroid(left.object, 1), EigenNear(cameras::project(studio.rig.left, p), 0.3));
    EXPECT_THAT(centroid(right.object, 1),
                EigenNear(cameras::project(studio.rig.right, studio.rig.right_T_left.isometry() * p), 0.3));
  }
}

TEST(Renderer, TheNearerObjectHidesTheFartherOne) {
  for (const bool is_nearer_first : {false, true}) {
    Studio studio;
    const auto near = box({-20, -20, 500}, {20, 20, 510}), far = box({-80, -80, 700}, {80, 80, 710});
    studio.add(is_nearer_first ? near : far);
    studio.add(is_nearer_first ? far : near);
    const View view = studio.render(studio.left);
    const int front = is_nearer_first ? 1 : 2, back = 3 - front;
    const Eigen::Vector2d middle = cameras::project(studio.rig.left, {0, 0, 500}),
                          beside = cameras::project(studio.rig.left, {60, 0, 700});
    EXPECT_EQ(int(view.object.at<std::uint8_t>(int(middle.y()), int(middle.x()))), front);
    EXPECT_NEAR(view.depth_mm.at<float>(int(middle.y()), int(middle.x())), 500, 1e-2);
    EXPECT_EQ(int(view.object.at<std::uint8_t>(int(beside.y()), int(beside.x()))), back);
    EXPECT_NEAR(view.depth_mm.at<float>(int(beside.y()), int(beside.x())), 700, 1e-2);
  }
}

TEST(Renderer, WhatIsNotShownIsNotThereAndComesBackUnchanged) {
  Studio studio;
  const int ball = studio.add(ellipsoid({0, 0, 600}, Eigen::Vector3d::Constant(30), 32));
  const View with = studio.render(studio.left, 0.2f);
  studio.scene.setShown(ball, false);
  const View without = studio.render(studio.left, 0.2f);
  EXPECT_EQ(cv::countNonZero(without.object), 0);
  EXPECT_EQ(cv::countNonZero(without.depth_mm), 0);
  EXPECT_LT(cv::norm(without.radiance - 0.2, cv::NORM_INF), 1e-6);
  studio.scene.setShown(ball, true);
  EXPECT_EQ(cv::norm(studio.render(studio.left, 0.2f).radiance, with.radiance, cv::NORM_INF), 0);
}

TEST(Renderer, AMovedObjectIsSeenAsAMovedMesh) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::AngleAxisd(0.5, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  pose.translation() = Eigen::Vector3d(20, -10, 640);
  const auto mesh = box({-40, -25, -10}, {40, 25, 10});
  Studio by_pose, by_mesh;
  by_pose.scene.setPose(by_pose.add(mesh), pose);
  by_mesh.add(moved(pose, mesh));
  const View a = by_pose.render(by_pose.right), b = by_mesh.render(by_mesh.right);
  cv::Mat differ = a.object != b.object;
  EXPECT_LT(cv::countNonZero(differ), 5);
  cv::Mat alike = a.object == b.object;
  EXPECT_LT(cv::norm(a.depth_mm, b.depth_mm, cv::NORM_INF, alike), 0.01);
}

TEST(Renderer, TheWallsLightIsScaledAndTheHeadsIsNot) {
  Studio studio;
  studio.add(box({-40, -40, 600}, {40, 40, 610}));
  const View full = studio.render(studio.left, 0.4f);
  studio.lighting.backdrop = 0.5;
  const View half = studio.render(studio.left, 0.4f);
  EXPECT_NEAR(half.radiance.at<float>(5, 5), 0.2, 1e-6);
  const Eigen::Vector2d middle = cameras::project(studio.rig.left, {0, 0, 600});
  EXPECT_EQ(half.radiance.at<float>(int(middle.y()), int(middle.x())),
            full.radiance.at<float>(int(middle.y()), int(middle.x())));
}

TEST(Renderer, ABrighterSurfaceIsBrighterInProportion) {
  const auto grey = [](float albedo) {
    Studio studio;
    studio.add(box({-40, -40, 600}, {40, 40, 610}), albedo);
    studio.lighting.lamps = {{Eigen::Vector3d(0, -300, 0), 1.0, 1000}};
    const Eigen::Vector2d middle = cameras::project(studio.rig.left, {0, 0, 600});
    return studio.render(studio.left).radiance.at<float>(int(middle.y()), int(middle.x()));
  };
  EXPECT_GT(grey(0.2f), 0.01f);
  EXPECT_NEAR(grey(0.6f) / grey(0.2f), 3.0, 1e-4);
}

TEST(Light, FollowsLambertAndTheInverseSquare) {
  RayScene empty;
  empty.commit();
  Lighting lighting;
  lighting.ambient = 0;
  lighting.lamps = {{Eigen::Vector3d(0, 0, 0), 0.8, 1000}};
  const auto diffuse = [&](double distance_mm, double tilt_rad) {
    const LightMeter meter(lighting, empty);
    const Eigen::Vector3d normal(std::sin(tilt_rad), 0, -std::cos(tilt_rad));  // towards the lamp at tilt 0
    return meter.falling({0, 0, distance_mm}, normal, {0, 0, -1}).diffuse;
  };
  EXPECT_NEAR(diffuse(1000, 0), 0.8, 1e-6) << "the intensity at the reference distance";
  EXPECT_NEAR(diffuse(2000, 0), 0.2, 1e-6);
  EXPECT_NEAR(diffuse(1000, M_PI / 3), 0.4, 1e-6);
  EXPECT_EQ(diffuse(1000, 2.0), 0.f) << "from behind";
}

TEST(Light, OfTwoLampsAddsUp) {
  RayScene empty;
  empty.commit();
  const auto diffuse = [&](const std::vector<Lamp>& lamps) {
    Lighting lighting;
    lighting.ambient = 0.1;
    lighting.lamps = lamps;
    return LightMeter(lighting, empty).falling({0, 0, 700}, {0, 0, -1}, {0, 0, -1}).diffuse;
  };
  const Lamp a{{300, -200, 0}, 0.5, 900}, b{{-100, -400, 100}, 0.7, 1200};
  EXPECT_NEAR(diffuse({a, b}) - diffuse({}), diffuse({a}) - diffuse({}) + diffuse({b}) - diffuse({}), 1e-6);
}

TEST(Light, AmbientLightIsStrongestFromAbove) {
  RayScene empty;
  empty.commit();
  Lighting lighting;
  lighting.ambient = 0.4;
  const LightMeter meter(lighting, empty);
  const auto from = [&](const Eigen::Vector3d& normal) {
    return meter.falling({0, 0, 600}, normal, {0, 0, -1}).diffuse;
  };
  EXPECT_NEAR(from({0, -1, 0}), 0.4, 1e-6) << "Room's and Camera's y point down";
  EXPECT_NEAR(from({0, 1, 0}), 0.2, 1e-6);
  EXPECT_NEAR(from({0, 0, -1}), 0.3, 1e-6);
}

TEST(Shadow, FallsWhereTheLampsLightIsBlocked) {
  Studio studio;
  studio.add(box({-200, -200, 800}, {200, 200, 810}));  // a wall
  studio.add(box({-10, -10, 400}, {10, 10, 402}));      // a small plate, half way to the lamp
  studio.lighting.ambient = 0.1;
  studio.lighting.lamps = {
      {Eigen::Vector3d(-120, 0, 0), 1.0, 1000}};  // beside the camera: shadow to the right
  const View lit = studio.render(studio.left);
  const auto at = [&](double x_mm, double y_mm) {
    const Eigen::Vector2d px = cameras::project(studio.rig.left, {x_mm, y_mm, 800});
    return lit.radiance.at<float>(int(std::lround(px.y())), int(std::lround(px.x())));
  };
  // From (-120, 0, 0) through the plate's middle (0, 0, 401) to the wall at 800: x = 119.
  EXPECT_NEAR(at(119, 0), 0.5 * 0.1 * 0.75, 0.005) << "ambient light only";
  EXPECT_GT(at(119, 40), 5 * at(119, 0));
  EXPECT_GT(at(80, 0), 5 * at(119, 0));
  EXPECT_GT(at(160, 0), 5 * at(119, 0));
  studio.lighting.has_lamp_shadows = false;
  const View even = studio.render(studio.left);
  const Eigen::Vector2d px = cameras::project(studio.rig.left, {119, 0, 800});
  EXPECT_GT(even.radiance.at<float>(int(std::lround(px.y())), int(std::lround(px.x()))), 5 * at(119, 0));
}

TEST(RayScene, ABlockedLineIsBlockedBothWaysAndNotBeyondItsEnds) {
  RayScene scene;
  scene.add(box({-10, -10, 100}, {10, 10, 110}));
  scene.commit();
  EXPECT_TRUE(scene.isBlocked({0, 0, 0}, {0, 0, 300}));
  EXPECT_TRUE(scene.isBlocked({0, 0, 300}, {0, 0, 0}));
  EXPECT_FALSE(scene.isBlocked({0, 0, 0}, {0, 0, 90}));
  EXPECT_FALSE(scene.isBlocked({50, 0, 0}, {50, 0, 300}));
  EXPECT_FALSE(scene.isBlocked({0, 0, 100}, {0, 0, 0})) << "the surface itself does not shade its own point";
}

TEST(RayScene, AHitIsOnTheRayAndOnTheSurface) {
  RayScene scene;
  const Eigen::Vector3d centre(10, -5, 300);
  scene.add(ellipsoid(centre, Eigen::Vector3d::Constant(50), 200));
  scene.commit();
  const Eigen::Vector3d origin(0, 0, 0), along = (centre + Eigen::Vector3d(12, 20, 0)) / 300;
  const auto hit = scene.intersect(origin, along);
  ASSERT_TRUE(hit);
  const Eigen::Vector3d p = origin + hit->distance * along;
  EXPECT_NEAR((p - centre).norm(), 50, 0.01);
  EXPECT_LT((p - hit->p_object_mm).norm(), 1e-6);
  EXPECT_GT(hit->normal.dot((p - centre) / 50), 0.9999) << "outward";
  EXPECT_FALSE(scene.intersect(origin, {0, 1, 0}));
}

TEST(CameraRays, ShowExactlyWhatLiesInsideTheImage) {
  const Studio studio;
  const auto shows = [&](double x_px, double y_px) {
    const Eigen::Vector2d ray = cameras::undistort(studio.rig.left, {x_px, y_px});
    return studio.left.shows(600 * ray.homogeneous());
  };
  EXPECT_TRUE(shows(0.5, 0.5));
  EXPECT_TRUE(shows(318.5, 238.5));
  EXPECT_FALSE(shows(-0.5, 100));
  EXPECT_FALSE(shows(319.5, 100));
  EXPECT_FALSE(shows(100, 239.5));
  EXPECT_FALSE(studio.left.shows({0, 0, -600})) << "behind the camera";
}

TEST(CameraRays, ABoxsPixelsLieInItsFrame) {
  Studio studio;
  studio.add(box({-40, -30, 580}, {60, 50, 660}));
  const View view = studio.render(studio.right);
  const auto frame = studio.right.boxOf({Eigen::Vector3d(-40, -30, 580), Eigen::Vector3d(60, 50, 660)},
                                        Eigen::Isometry3d::Identity());
  ASSERT_TRUE(frame);
  std::vector<cv::Point> seen;
  cv::findNonZero(view.object, seen);
  ASSERT_GT(seen.size(), 1000u);
  for (const auto& px : seen) ASSERT_TRUE(frame->contains(px)) << px;
  EXPECT_LT(frame->area(), 3 * int(seen.size())) << "and it is no larger than needed";
  EXPECT_FALSE(studio.left.boxOf({Eigen::Vector3d(-40, -30, -100), Eigen::Vector3d(60, 50, 660)},
                                 Eigen::Isometry3d::Identity()))
      << "reaches behind the camera";
}

/// Volume by the divergence theorem: positive where all triangles are seen counter-clockwise from outside.
double volumeOf(const surface::TriangleMesh& mesh) {
  double six = 0;
  for (const auto& t : mesh.triangles)
    six += mesh.vertices_mm[t[0]].dot(mesh.vertices_mm[t[1]].cross(mesh.vertices_mm[t[2]]));
  return six / 6;
}

TEST(Shapes, AreClosedAndTurnOutwards) {
  EXPECT_NEAR(volumeOf(box({-1, 2, 3}, {4, 8, 5})), 5 * 6 * 2, 1e-9);
  EXPECT_NEAR(volumeOf(cylinder({5, -7}, 20, 10, 60)), M_PI * 400 * 50, 0.005 * M_PI * 400 * 50);
  EXPECT_NEAR(volumeOf(ellipsoid({3, 2, 1}, {20, 30, 40}, 96)), 4.0 / 3 * M_PI * 24000, 0.003 * 100531);
  EXPECT_NEAR(volumeOf(bar({1, 2, 3}, {40, -20, 60}, 4)), 16 * (Eigen::Vector3d(39, -22, 57)).norm(), 1e-6);
  const auto a = box({0, 0, 0}, {1, 1, 1}), b = box({5, 5, 5}, {7, 7, 7});
  EXPECT_NEAR(volumeOf(joined(a, b)), 9, 1e-9);
}

TEST(Shapes, NormalsAreThoseOfTheirTriangles) {
  for (const auto& mesh :
       {box({-1, 2, 3}, {4, 8, 5}), cylinder({0, 0}, 10, 0, 30), bar({0, 0, 0}, {9, 9, 9}, 2)})
    for (const auto& t : mesh.triangles) {
      const Eigen::Vector3d facet = (mesh.vertices_mm[t[1]] - mesh.vertices_mm[t[0]])
                                        .cross(mesh.vertices_mm[t[2]] - mesh.vertices_mm[t[0]])
                                        .normalized();
      for (int corner = 0; corner < 3; ++corner) EXPECT_GT(facet.dot(mesh.normals[t[corner]]), 0.99);
    }
}

TEST(NoiseField, HasZeroMeanAndUnitDeviationAndItsSeedDecides) {
  const NoiseField field(3), same(3), other(4);
  double sum = 0, squares = 0, differ = 0;
  int count = 0;
  for (double x = 0; x < 60; x += 1.5)
    for (double y = 0; y < 60; y += 1.5)
      for (double z = 0; z < 30; z += 1.5, ++count) {
        const Eigen::Vector3d p(x, y, z);
        const float value = field.at(p, 1.0);
        ASSERT_EQ(value, same.at(p, 1.0));
        sum += value, squares += value * value, differ += std::abs(value - other.at(p, 1.0)) > 0.1;
      }
  EXPECT_NEAR(sum / count, 0, 0.03);
  EXPECT_NEAR(squares / count, 0.5, 0.35) << "interpolation between cells lowers the variance";
  EXPECT_GT(differ / count, 0.8);
}

TEST(NoiseField, IsSmoothOnTheScaleOfItsGrain) {
  const NoiseField field(3);
  double steepest = 0;
  for (double x = 0; x < 200; x += 0.7)
    steepest =
        std::max(steepest, double(std::abs(field.at({x + 0.01, 5, 9}, 2.0) - field.at({x, 5, 9}, 2.0))));
  EXPECT_LT(steepest, 0.05);
}

}  // namespace
}  // namespace facenav::room
