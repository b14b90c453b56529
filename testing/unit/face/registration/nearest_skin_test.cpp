#include "field/nearest_skin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "facenav/core/error.h"
#include "model_field.h"

namespace facenav::registration {
namespace {

using facenav::testing::ModelHead;
using facenav::testing::towards;

/// A smooth ellipsoid of 70 x 90 x 105 mm, cut off at z = -50 mm.
ModelHead ellipsoid() {
  ModelHead head;
  head.bumps.clear();
  head.radii_mm = {70, 90, 105};
  return head;
}

/// Distance of `p` from a triangle: the least of those to its edges, and of that to its plane if `p` lies
/// above it.
double distanceToTriangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                          const Eigen::Vector3d& c) {
  const auto toSegment = [&](const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
    const double t = std::clamp((p - u).dot(v - u) / (v - u).squaredNorm(), 0.0, 1.0);
    return (p - u - t * (v - u)).norm();
  };
  double least = std::min({toSegment(a, b), toSegment(b, c), toSegment(c, a)});
  const Eigen::Vector3d n = (b - a).cross(c - a);
  const bool is_inside =
      n.dot((b - a).cross(p - a)) > 0 && n.dot((c - b).cross(p - b)) > 0 && n.dot((a - c).cross(p - c)) > 0;
  return is_inside ? std::min(least, std::abs(n.normalized().dot(p - a))) : least;
}

TEST(NearestSkin, IsTheNearestOfAllTriangles) {
  const SkinModel skin = ModelHead().skin(-40);
  const NearestSkin nearest(skin);
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  const auto& v = skin.points.points_mm;
  std::vector<double> off_mm;
  for (int i = 0; i < 40; ++i) {
    const Eigen::Vector3d direction =
        Eigen::Vector3d(normal(random), normal(random), std::abs(normal(random))).normalized();
    const Eigen::Vector3d p = ModelHead().at(direction) + 4 * normal(random) * direction;
    double least = 1e9;
    for (const auto& t : skin.triangles) {
      if ((v[std::size_t(t[0])] - p).squaredNorm() > 30 * 30) continue;
      least = std::min(
          least, distanceToTriangle(p, v[std::size_t(t[0])], v[std::size_t(t[1])], v[std::size_t(t[2])]));
    }
    const SkinContact contact = nearest.nearest(p);
    off_mm.push_back(std::abs(contact.distance_mm) - least);
    EXPECT_GT(off_mm.back(), -1e-6) << "nothing is nearer than the nearest";
    EXPECT_NEAR((p - contact.closest_mm).norm(), std::abs(contact.distance_mm), 1e-9);
  }
  // The nearest vertex need not belong to the nearest triangle: on facets of 2 mm that costs hundredths.
  std::sort(off_mm.begin(), off_mm.end());
  EXPECT_LT(off_mm[20], 0.005);
  EXPECT_LT(off_mm[37], 0.1);
}

TEST(NearestSkin, IsPositiveOutsideAlongTheOutwardNormal) {
  const ModelHead head = ellipsoid();
  const SkinModel skin = head.skin(-50);
  const NearestSkin nearest(skin);
  for (const double up_deg : {-10.0, 20.0, 55.0})
    for (const double right_deg : {-120.0, -40.0, 0.0, 75.0, 170.0})
      for (const double out_mm : {-5.0, -0.5, 0.5, 5.0, 25.0}) {
        const Eigen::Vector3d direction = towards(right_deg, up_deg), normal = head.normal(direction);
        const SkinContact contact = nearest.nearest(head.at(direction) + out_mm * normal);
        EXPECT_NEAR(contact.distance_mm, out_mm, 0.03);
        EXPECT_GT(contact.normal.dot(normal), 0.999);
        EXPECT_NEAR(contact.normal.norm(), 1.0, 1e-9);
        EXPECT_FALSE(contact.is_on_border);
        EXPECT_FALSE(contact.is_beyond_scan);
      }
}

TEST(NearestSkin, SaysWhereTheScanCutsIt) {
  const SkinModel skin = ellipsoid().skin(-50);
  const NearestSkin nearest(skin);
  // Below the cut the nearest skin is the rim, all around.
  for (const double turn_deg : {0.0, 90.0, 200.0}) {
    const Eigen::Vector3d below = towards(turn_deg, 0) * 72 + Eigen::Vector3d(0, 0, -60);
    const SkinContact contact = nearest.nearest(below);
    EXPECT_TRUE(contact.is_on_border);
    EXPECT_TRUE(contact.is_beyond_scan);
    EXPECT_TRUE(nearest.isOnBorder(contact.vertex));
  }
  EXPECT_FALSE(nearest.isBeyondScan({0, 80, -49.9}));
  EXPECT_TRUE(nearest.isBeyondScan({0, 80, -50.1}));
}

TEST(NearestSkin, FindsTheNearestVertexFromFarAway) {
  const SkinModel skin = ellipsoid().skin(-50);
  const NearestSkin nearest(skin);
  const auto& v = skin.points.points_mm;
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 30; ++i) {
    const Eigen::Vector3d direction =
        Eigen::Vector3d(normal(random), normal(random), std::abs(normal(random))).normalized();
    const Eigen::Vector3d p = (120 + 8 * i) * direction;  // 15 to 280 mm outside
    double least = 1e9;
    for (const auto& q : v) least = std::min(least, (q - p).norm());
    EXPECT_NEAR((v[std::size_t(nearest.nearestVertex(p))] - p).norm(), least, 0.5) << p.transpose();
  }
}

TEST(NearestSkin, VerticesInNoTriangleAreNoSkin) {
  SkinModel skin = ellipsoid().skin(-50);
  skin.points.points_mm.emplace_back(0, 0, 0);  // in the middle of the head
  skin.points.normals.emplace_back(0, 0, 1);
  const NearestSkin nearest(skin);
  EXPECT_LT(nearest.nearest({1, 0, 0}).distance_mm, -49);
}

TEST(NearestSkin, RefusesASkinWithoutNormalsOrTriangles) {
  SkinModel without_normals = ellipsoid().skin(-50), without_triangles = without_normals;
  without_normals.points.normals.clear();
  without_triangles.triangles.clear();
  EXPECT_THROW(NearestSkin{without_normals}, Error);
  EXPECT_THROW(NearestSkin{without_triangles}, Error);
}

}  // namespace
}  // namespace facenav::registration
