// Position of an edge along a row, on known edges: a blurred step, integrated over each pixel.

#include "edge_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace facenav::coil_tracking {
namespace {

constexpr int kPixels = 41;

/// Integral of the blurred step from -infinity to u, for sigma 1.
double stepIntegral(double u) {
  return u * 0.5 * std::erfc(-u / std::sqrt(2.0)) + std::exp(-0.5 * u * u) / std::sqrt(2 * M_PI);
}

/// Row of pixels `step` bytes apart, with an edge at `edge_px`; black after it on request.
struct Row {
  std::vector<std::uint8_t> bytes;
  int step;
  Row(double edge_px, double blur_px, bool is_black_after, double black = 30, double white = 200,
      int bytes_apart = 1, double noise = 0, unsigned seed = 1)
      : bytes(std::size_t(kPixels * bytes_apart), 77), step(bytes_apart) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0, 1);
    for (int x = 0; x < kPixels; ++x) {
      const double after = (x + 0.5 - edge_px) / blur_px, before = (x - 0.5 - edge_px) / blur_px;
      double share = blur_px * (stepIntegral(after) - stepIntegral(before));  // 0 before the edge, 1 after it
      if (is_black_after) share = 1 - share;
      const double grey = black + share * (white - black) + noise * normal(random);
      bytes[std::size_t(x * step)] = std::uint8_t(std::clamp(std::lround(grey), 0L, 255L));
    }
  }
};

TEST(EdgeFilter, FindsAnEdgeAnywhereInItsPixel) {
  for (const double blur_px : {0.55, 0.75, 1.0, 1.4})
    for (const bool is_black_after : {false, true})
      for (double edge = 20.0; edge < 21.0; edge += 0.09) {
        const Row row(edge, blur_px, is_black_after);
        const auto found =
            locateEdge(edgeWeights(4, blur_px), row.bytes.data(), 1, edge + 0.2, is_black_after, 40);
        ASSERT_TRUE(found) << blur_px << ", " << edge;
        EXPECT_NEAR(found->offset_px, -0.2, 0.03) << blur_px << ", " << edge;
        EXPECT_NEAR(found->contrast, 170, 15);
      }
}

TEST(EdgeFilter, AtTheRightPlaceTheOffsetIsNearlyZero) {
  for (const int taps : {2, 3, 4})
    for (double edge = 19.5; edge < 20.5; edge += 0.11) {
      const Row row(edge, 0.75, true);
      const auto found = locateEdge(edgeWeights(taps, 0.75), row.bytes.data(), 1, edge, true, 40);
      ASSERT_TRUE(found) << taps;
      EXPECT_NEAR(found->offset_px, 0, 0.02) << taps << ", " << edge;
    }
}

TEST(EdgeFilter, LooksTheSameDownAColumn) {
  const Row row(20.3, 1.0, false, 30, 200, 1), column(20.3, 1.0, false, 30, 200, 64);
  const auto a = locateEdge(edgeWeights(3, 1.0), row.bytes.data(), 1, 20.0, false, 40),
             b = locateEdge(edgeWeights(3, 1.0), column.bytes.data(), 64, 20.0, false, 40);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->offset_px, b->offset_px);
  EXPECT_EQ(a->contrast, b->contrast);
}

TEST(EdgeFilter, IsMirrorSymmetric) {
  const Row falling(20.0 + 0.27, 0.75, true), rising(20.0 - 0.27, 0.75, false);
  const auto a = locateEdge(edgeWeights(4, 0.75), falling.bytes.data(), 1, 20.0, true, 40),
             b = locateEdge(edgeWeights(4, 0.75), rising.bytes.data(), 1, 20.0, false, 40);
  ASSERT_TRUE(a && b);
  EXPECT_NEAR(a->offset_px, -b->offset_px, 2e-3);
}

TEST(EdgeFilter, TheOtherPolarityAndAFaintEdgeAreNone) {
  const Row row(20.2, 0.75, true);
  EXPECT_FALSE(locateEdge(edgeWeights(4, 0.75), row.bytes.data(), 1, 20.0, false, 40));
  const Row faint(20.2, 0.75, true, 100, 120);
  EXPECT_FALSE(locateEdge(edgeWeights(4, 0.75), faint.bytes.data(), 1, 20.0, true, 40));
  EXPECT_TRUE(locateEdge(edgeWeights(4, 0.75), faint.bytes.data(), 1, 20.0, true, 10));
  const Row flat(1000, 1.0, true);
  EXPECT_FALSE(locateEdge(edgeWeights(4, 1.0), flat.bytes.data(), 1, 20.0, true, 10));
}

TEST(EdgeFilter, NeverReportsAnEdgeBeyondItsReach) {
  for (double edge = 8; edge < 33; edge += 0.5) {
    const Row row(edge, 0.75, true);
    const auto found = locateEdge(edgeWeights(4, 0.75), row.bytes.data(), 1, 20.0, true, 5);
    if (found) {
      EXPECT_LE(std::abs(found->offset_px), 1.5 + 0.75);
    }
    if (std::abs(edge - 20) >= 8) {
      EXPECT_FALSE(found) << edge;
    }
  }
}

TEST(EdgeFilter, NoiseMovesItByLittleMoreThanTheBoundOfARow) {
  // Cramer-Rao of one row: noise / contrast * sqrt(2 sqrt(pi) sigma), sigma of blur and pixel together.
  const double blur_px = 0.75, noise = 2.0, sigma = std::hypot(blur_px, std::sqrt(1.0 / 12));
  const double bound_px = noise / 170 * std::sqrt(2 * std::sqrt(M_PI) * sigma);
  double sum = 0, squares = 0;
  const int count = 2000;
  for (int n = 0; n < count; ++n) {
    const double edge = 20 + (n % 10) * 0.1 - 0.45;
    const Row row(edge, blur_px, true, 30, 200, 1, noise, unsigned(n + 1));
    const auto found = locateEdge(edgeWeights(4, blur_px), row.bytes.data(), 1, edge, true, 40);
    ASSERT_TRUE(found);
    sum += found->offset_px, squares += found->offset_px * found->offset_px;
  }
  EXPECT_NEAR(sum / count, 0, 0.005) << "no bias";
  EXPECT_LT(std::sqrt(squares / count), 1.35 * bound_px)
      << "nine pixels and an unknown white allow 1.21 times the bound of an endless row";
  EXPECT_GT(std::sqrt(squares / count), 0.9 * bound_px) << "nothing beats the bound";
}

TEST(EdgeSearch, FindsTheEdgeWithinItsReach) {
  for (const bool is_black_after : {false, true})
    for (double edge = 14; edge <= 26; edge += 0.35) {
      const Row row(edge, 0.8, is_black_after);
      const auto found = searchEdge(row.bytes.data(), 1, 20.0, is_black_after, 7, 20);
      ASSERT_TRUE(found) << edge;
      EXPECT_NEAR(found->offset_px, edge - 20.0, 0.35) << edge;
      EXPECT_GT(found->contrast, 120) << "blur takes a part of it";
      EXPECT_LT(found->contrast, 172);
    }
}

TEST(EdgeSearch, TakesTheStrongestOfItsPolarityOnly) {
  Row row(17.0, 0.7, true, 120, 200);
  for (int x = 24; x < kPixels; ++x) row.bytes[std::size_t(x)] = 10;  // a stronger fall at 23.5
  auto found = searchEdge(row.bytes.data(), 1, 20.0, true, 8, 20);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->offset_px, 3.5, 0.35);
  found = searchEdge(row.bytes.data(), 1, 20.0, true, 1, 60);
  EXPECT_FALSE(found) << "neither lies within a pixel";
  EXPECT_FALSE(searchEdge(row.bytes.data(), 1, 20.0, false, 8, 20)) << "no rise";
}

}  // namespace
}  // namespace facenav::coil_tracking
