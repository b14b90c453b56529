// Sampling, gradients and means of ScalarField, against closed forms and sums written out.

#include "scalar_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace facenav::atlas {
namespace {

ScalarField made(const std::array<int, 3>& size, const std::function<double(int, int, int)>& value) {
  ScalarField field(size);
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) field.values[field.index(i, j, k)] = float(value(i, j, k));
  return field;
}

ScalarField noise(const std::array<int, 3>& size, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(2.0, 1.0);
  return made(size, [&](int, int, int) { return normal(random); });
}

TEST(ScalarField, SamplesALinearFieldExactly) {
  const auto field = made({7, 6, 5}, [](int i, int j, int k) { return 3 * i - 2 * j + 0.5 * k + 1; });
  std::mt19937 random(1);
  std::uniform_real_distribution<float> part(0.f, 1.f);
  for (int n = 0; n < 200; ++n) {
    const Eigen::Vector3f p(6 * part(random), 5 * part(random), 4 * part(random));
    EXPECT_NEAR(sample(field, p), 3 * p.x() - 2 * p.y() + 0.5f * p.z() + 1, 1e-4) << p.transpose();
  }
}

TEST(ScalarField, BeyondTheGridTheEdgeGoesOn) {
  const auto field = noise({4, 5, 6}, 2);
  EXPECT_FLOAT_EQ(sample(field, {-3, 2, 3}), field.at(0, 2, 3));
  EXPECT_FLOAT_EQ(sample(field, {99, 2, 3}), field.at(3, 2, 3));
  EXPECT_FLOAT_EQ(sample(field, {1, -0.5f, 3}), field.at(1, 0, 3));
  EXPECT_FLOAT_EQ(sample(field, {1, 2, 5.5f}), field.at(1, 2, 5));
  EXPECT_FLOAT_EQ(sample(field, {3, 4, 5}), field.at(3, 4, 5)) << "the last node itself";
}

TEST(ScalarField, OfOneSliceHasNoSlopeAcrossIt) {
  const auto field = made({5, 5, 1}, [](int i, int j, int) { return i * j; });
  EXPECT_NEAR(sample(field, {1.5f, 2.f, 0.7f}), 3.0f, 1e-6);
  EXPECT_EQ(gradientAt(field, 2, 2, 0).z(), 0.f);
}

TEST(ScalarField, TheGradientIsCentralInsideAndOneSidedAtTheEdge) {
  const auto squares = made({6, 5, 4}, [](int i, int j, int k) { return i * i + 4 * j - 3 * k; });
  for (int i = 1; i < 5; ++i)
    EXPECT_TRUE(gradientAt(squares, i, 2, 1).isApprox(Eigen::Vector3f(2.f * float(i), 4, -3))) << i;
  EXPECT_EQ(gradientAt(squares, 0, 2, 1).x(), 1.f);  // 1 - 0
  EXPECT_EQ(gradientAt(squares, 5, 2, 1).x(), 9.f);  // 25 - 16
  EXPECT_EQ(gradientAt(squares, 2, 0, 3).y(), 4.f);
  EXPECT_EQ(gradientAt(squares, 2, 0, 3).z(), -3.f);
}

TEST(ScalarField, TheBoxMeanIsTheMeanOfTheNodesThatExist) {
  const std::array<int, 3> size{9, 8, 7};
  const auto field = noise(size, 3);
  for (const int radius : {1, 2, 4}) {
    const auto mean = boxMean(field, radius);
    for (int k = 0; k < size[2]; ++k)
      for (int j = 0; j < size[1]; ++j)
        for (int i = 0; i < size[0]; ++i) {
          double sum = 0;
          int count = 0;
          for (int c = std::max(0, k - radius); c <= std::min(size[2] - 1, k + radius); ++c)
            for (int b = std::max(0, j - radius); b <= std::min(size[1] - 1, j + radius); ++b)
              for (int a = std::max(0, i - radius); a <= std::min(size[0] - 1, i + radius); ++a)
                sum += field.at(a, b, c), ++count;
          ASSERT_NEAR(mean.at(i, j, k), sum / count, 1e-4) << radius;
        }
  }
}

TEST(ScalarField, SmoothingSpreadsAPointByTwoThirdsOfANodePerPass) {
  for (const int passes : {1, 3, 6}) {
    const auto spread = smoothed(
        made({31, 31, 31}, [](int i, int j, int k) { return i == 15 && j == 15 && k == 15; }), passes);
    double sum = 0;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero(), squares = mean;
    for (int k = 0; k < 31; ++k)
      for (int j = 0; j < 31; ++j)
        for (int i = 0; i < 31; ++i) {
          const double w = spread.at(i, j, k);
          const Eigen::Vector3d p(i - 15, j - 15, k - 15);
          sum += w, mean += w * p, squares += w * p.cwiseProduct(p);
        }
    EXPECT_NEAR(sum, 1.0, 1e-5) << passes;
    EXPECT_LT(mean.norm(), 1e-5) << passes;
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(squares[axis], 2.0 / 3 * passes, 1e-4) << passes;
  }
}

TEST(ScalarField, SmoothingKeepsAConstantAtTheEdgesToo) {
  const auto flat = smoothed(made({5, 4, 3}, [](int, int, int) { return 7; }), 4);
  for (const float v : flat.values) EXPECT_NEAR(v, 7, 1e-5);
}

}  // namespace
}  // namespace facenav::atlas
