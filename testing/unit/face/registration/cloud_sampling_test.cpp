#include "cloud/cloud_sampling.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>

#include "cloud/cube_numbers.h"

namespace facenav::registration {
namespace {

/// Square of 100 x 100 mm at z = 600 mm; the half with x > 0 is ten times as dense.
PointCloud<Camera> unevenSquare() {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  PointCloud<Camera> cloud;
  for (int i = 0; i < 11000; ++i) {
    const double side = i < 10000 ? 1 : -1;
    cloud.points_mm.emplace_back(side * 50 * uniform(random), 100 * uniform(random) - 50, 600);
  }
  return cloud;
}

double shareAtRight(const PointCloud<Camera>& cloud, const std::vector<int>& points) {
  int right = 0;
  for (const int p : points) right += cloud.points_mm[std::size_t(p)].x() > 0;
  return double(right) / double(points.size());
}

TEST(CloudSampling, ThinsToOnePointACubeSoThatDenseSkinCountsNoMore) {
  const auto cloud = unevenSquare();
  const auto chosen = thinOut(cloud, 10.0, 100000);
  std::set<std::array<int, 2>> cubes;
  for (const int p : chosen) {
    const Eigen::Vector3d& at = cloud.points_mm[std::size_t(p)];
    cubes.insert({int(std::floor(at.x() / 10)), int(std::floor(at.y() / 10))});
  }
  EXPECT_EQ(cubes.size(), chosen.size()) << "no cube is taken twice";
  EXPECT_EQ(chosen.size(), 100u) << "and none is left out: 10 x 10 cubes, 10 points and more in each";
  EXPECT_NEAR(shareAtRight(cloud, chosen), 0.5, 1e-9);
}

TEST(CloudSampling, EnlargesTheCubesUntilTheNumberFits) {
  const auto cloud = unevenSquare();
  for (const std::size_t most : {5u, 40u, 900u}) {
    const auto chosen = thinOut(cloud, 0.5, most);
    EXPECT_LE(chosen.size(), most);
    EXPECT_GT(chosen.size(), most / 4) << "no more are lost than the number asks";
    EXPECT_EQ(std::set<int>(chosen.begin(), chosen.end()).size(), chosen.size());
  }
}

TEST(CloudSampling, LeavesOutPointsThatAreNoNumbersOrAbsurdlyFar) {
  PointCloud<Camera> cloud;
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinite = std::numeric_limits<double>::infinity();
  cloud.points_mm = {{1, 2, 600}, {nan, 2, 600}, {1, -infinite, 600}, {1, 2, 2e5}, {-40, 0, 700}};
  EXPECT_EQ(finitePoints(cloud), (std::vector<int>{0, 4}));
  const auto chosen = thinOut(cloud, 1.0, 10);
  EXPECT_EQ(std::set<int>(chosen.begin(), chosen.end()), (std::set<int>{0, 4}));
  EXPECT_TRUE(thinOut(PointCloud<Camera>(), 1.0, 10).empty());
}

TEST(CloudSampling, SomeOfThemAreEvenlyChosenAndInOrder) {
  std::vector<int> points;
  for (int i = 0; i < 1000; ++i) points.push_back(7 * i);
  const auto some = someOf(points, 10);
  ASSERT_EQ(some.size(), 10u);
  for (std::size_t i = 0; i < some.size(); ++i) EXPECT_EQ(some[i], 700 * int(i));
  EXPECT_EQ(someOf(points, 1000), points);
  EXPECT_EQ(someOf(points, 2000), points);
}

TEST(CloudSampling, PicksPointsWithTheirNormals) {
  PointCloud<Camera> cloud;
  for (int i = 0; i < 4; ++i) cloud.points_mm.emplace_back(i, 0, 0), cloud.normals.emplace_back(0, i, 1);
  const auto two = pick(cloud, {3, 1});
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two.points_mm[0].x(), 3);
  EXPECT_EQ(two.normals[1].y(), 1);
  cloud.normals.pop_back();  // fewer normals than points count as none
  EXPECT_TRUE(pick(cloud, {3, 1}).normals.empty());
}

TEST(CubeNumbers, AreThoseOfAMapWhateverTheSignAndHoweverMany) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> uniform(-300, 300);
  CubeNumbers numbers(4.0, 5);  // far fewer expected than arrive
  std::map<std::array<int, 3>, int> expected;
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3f p(uniform(random), uniform(random), 0.02f * uniform(random));
    const std::array<int, 3> cube{int(std::floor(p.x() / 4)), int(std::floor(p.y() / 4)),
                                  int(std::floor(p.z() / 4))};
    const int next = int(expected.size());
    const int found_before = numbers.find(p);
    const auto [at, is_new] = expected.emplace(cube, next);
    EXPECT_EQ(found_before, is_new ? -1 : at->second);
    ASSERT_EQ(numbers.of(p), at->second);
  }
  EXPECT_EQ(std::size_t(numbers.size()), expected.size());
}

TEST(CubeNumbers, CubesBesideZeroAreTwo) {
  CubeNumbers numbers(10.0);
  EXPECT_NE(numbers.of({-1, 0, 0}), numbers.of({1, 0, 0}));
  EXPECT_EQ(numbers.of({-9, 0, 0}), numbers.find({-1, 0, 0}));
}

}  // namespace
}  // namespace facenav::registration
