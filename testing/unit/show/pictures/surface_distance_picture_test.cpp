#include "facenav/pictures/surface_distance_picture.h"

#include <gtest/gtest.h>

#include "support/ball_mesh.h"

// The distance picture of a ball: its right half is outside the phi-theta surface, its left half inside.

namespace facenav {
namespace {

constexpr double kRadius_mm = 40;

surface::DetailedCortex halves() {
  surface::DetailedCortex cortex;
  cortex.mesh = testing::ballMesh(kRadius_mm, 200, 400);
  for (const auto& p : cortex.mesh.vertices_mm) cortex.distance_mm.push_back(p.x() > 0 ? 5.f : -5.f);
  return cortex;
}

/// Colour by sign: red outside, blue inside.
std::array<double, 3> redOrBlue(double mm) {
  return mm > 0 ? std::array<double, 3>{1, 0, 0} : std::array<double, 3>{0, 0, 1};
}

TEST(SurfaceDistancePicture, ColoursEachSideByItsDistanceWithoutGaps) {
  const auto picture = pictures::drawSurfaceDistance(halves(), {}, 10, redOrBlue);
  ASSERT_FALSE(picture.empty());
  const int width = picture.width_px / 3, margin = 12, title = 16, radius = int(2 * kRadius_mm);
  const auto countIn = [&](int tile, int channel) {
    int count = 0;
    for (int v = 0; v < 2 * radius; ++v)
      for (int u = 0; u < 2 * radius; ++u) {
        const int x = u - radius, y = v - radius;
        if (x * x + y * y > 0.9 * radius * radius) continue;
        const auto* p = picture.pixel(tile * width + margin + u, margin + title + v);
        count += p[channel] > 60 && p[2 - channel] < 40;
      }
    return count / (0.9 * M_PI * radius * radius);
  };
  EXPECT_GT(countIn(0, 2), 0.99);         // left side: all inside
  EXPECT_GT(countIn(1, 0), 0.99);         // right side: all outside
  EXPECT_NEAR(countIn(2, 0), 0.5, 0.02);  // from above: half and half
  EXPECT_NEAR(countIn(2, 2), 0.5, 0.02);
}

TEST(SurfaceDistancePicture, IsEmptyForAnEmptyCortex) {
  EXPECT_TRUE(pictures::drawSurfaceDistance({}, {}, 10, redOrBlue).empty());
}

}  // namespace
}  // namespace facenav
