#include "field/point_kernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "cloud/cube_numbers.h"
#include "facenav/registration/scalp_field.h"
#include "support/model_head.h"

namespace facenav::registration {
namespace {

using facenav::testing::ModelHead;

constexpr int kPoints = 2000, kPadded = 2048;

/// Points in a box twice as wide as the head, one in fifty not a number.
struct Cloud {
  std::vector<float> at_mm[3], normal[3], weight;

  Cloud() {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> place(-70, 70), unit(0, 1);
    for (int p = 0; p < kPadded; ++p) {
      const bool is_number = p < kPoints && p % 50 != 7;
      for (int a = 0; a < 3; ++a) {
        at_mm[a].push_back(is_number ? place(random) : std::nanf(""));
        normal[a].push_back(unit(random) - 0.5f);
      }
      weight.push_back(unit(random));
    }
  }
  point::Points points(bool has_normals) const {
    point::Points points;
    for (int a = 0; a < 3; ++a) {
      points.at_mm[a] = at_mm[a].data();
      points.normal[a] = has_normals ? normal[a].data() : nullptr;
    }
    points.weight = weight.data();
    return points;
  }
};

point::View view() {
  const Eigen::Matrix3f r = Eigen::AngleAxisf(0.4f, Eigen::Vector3f(1, 2, 3).normalized()).matrix();
  point::View view;
  for (int i = 0; i < 3; ++i) {
    view.t[i] = i == 1 ? 600.0f : 10.0f;
    for (int j = 0; j < 3; ++j) view.r[i][j] = r(i, j);
  }
  return view;
}

void expectNear(float a, float b, float tolerance, const char* what) {
  if (std::isnan(a) || std::isnan(b))
    EXPECT_EQ(std::isnan(a), std::isnan(b)) << what;
  else
    EXPECT_NEAR(a, b, tolerance) << what;
}

TEST(PointKernel, TheFastestAgreesWithTheBaseToRounding) {
  if (&point::kernel() == &point::baseKernel()) GTEST_SKIP() << "no AVX2";
  ModelHead head;  // small: built quickly
  head.bumps.clear();
  head.radii_mm.setConstant(35);
  const ScalpField field(head.skin(-15));
  Cloud cloud;
  point::View from = view();
  // The camera looks from 600 mm before the face.
  for (int p = 0; p < kPoints; ++p)
    for (int a = 0; a < 3; ++a) cloud.at_mm[a][std::size_t(p)] -= from.r[1][a] * 600.0f;
  for (const bool is_fine : {true, false})
    for (const bool has_normals : {true, false}) {
      const point::Points points = cloud.points(has_normals);
      int valid = 0, none = 0;
      for (int first = 0; first < kPoints; first += point::kBlock) {
        const int count = std::min(point::kBlock, kPoints - first);
        point::Block base, fast;
        point::baseKernel().measure(field.grids(), points, first, count, from, is_fine, base);
        point::kernel().measure(field.grids(), points, first, count, from, is_fine, fast);
        for (int i = 0; i < count; ++i) {
          expectNear(base.residual_mm[i], fast.residual_mm[i], 5e-4f, "distance");
          for (int a = 0; a < 3; ++a) expectNear(base.normal[a][i], fast.normal[a][i], 1e-3f, "normal");
          EXPECT_EQ(base.is_valid[i], fast.is_valid[i]);
          valid += base.is_valid[i] > 0;
          none += !(base.residual_mm[i] < point::kNoSkin_mm);
        }
        const point::Loss loss{30, 20, {0, 10, 5}};
        const point::Sums a = point::baseKernel().sum(base, points, first, loss);
        const point::Sums b = point::kernel().sum(base, points, first, loss);
        EXPECT_NEAR(a.weight, b.weight, 1e-5 * (1 + a.weight));
        for (int k = 0; k < 28; ++k)
          EXPECT_NEAR(a.products[k], b.products[k], 1e-5 * (100 + 1e4 * double(a.weight))) << k;
      }
      EXPECT_GT(valid, 40);
      EXPECT_GT(none, 40);
    }
}

TEST(CubeNumbers, NumberCubesInTheOrderInWhichTheyAreMet) {
  CubeNumbers cubes(10.0, 4);
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(cubes.of(Eigen::Vector3f(10.0f * float(i) - 5000 + 3, -1, 4)), i);
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(cubes.of(Eigen::Vector3f(10.0f * float(i) - 5000 + 8, -9, 0)), i);
    EXPECT_EQ(cubes.find(Eigen::Vector3f(10.0f * float(i) - 5000 + 8, -9, 9.9f)), i);
  }
  EXPECT_EQ(cubes.find(Eigen::Vector3f(3, 1, 4)), -1);  // the next cube in y
  EXPECT_EQ(cubes.size(), 1000);
}

}  // namespace
}  // namespace facenav::registration
