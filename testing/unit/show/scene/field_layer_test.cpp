#include "facenav/scene/field_layer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "facenav/scene/display.h"
#include "support/ball_mesh.h"

namespace facenav::scene {
namespace {

int coloured(const RgbImage& a, const RgbImage& b) {
  int n = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) n += std::abs(a.rgb[i] - b.rgb[i]) > 16;
  return n;
}

/// Field that falls from 100 V/m at the top of a ball of 60 mm to 0 at its bottom.
FieldPicture falling() {
  FieldPicture picture;
  const auto brain = std::make_shared<surface::TriangleMesh>(testing::ballMesh(60.0));
  for (const auto& p_mm : brain->vertices_mm) picture.strength.push_back(float(100 * (p_mm.z() + 60) / 120));
  picture.surface = brain;
  picture.peak = 100;
  picture.peak_place = Point<Mri>(0, 0, 60);
  picture.peak_words = "maximum 100 V/m";
  return picture;
}

TEST(FieldLayer, ColoursRunFromAFifthOfTheMaximum) {
  EXPECT_DOUBLE_EQ(fieldColours(80).low, 16);
  EXPECT_DOUBLE_EQ(fieldColours(80).high, 80);
}

TEST(FieldLayer, SlicesGetTheSameColours) {
  const auto overlay = fieldOverlay(std::make_shared<volume::Volume>(), std::make_shared<volume::Mask>(), 80);
  EXPECT_TRUE(overlay.is_strength);
  EXPECT_EQ(overlay.threshold, fieldColours(80).low);
  EXPECT_EQ(overlay.full, fieldColours(80).high);
  EXPECT_TRUE(overlay.within);
}

TEST(FieldLayer, LinesLieAt50And75And90PercentOfTheMaximum) {
  if (!hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  NavigationScene scene;
  scene.setScalp(testing::ballMesh(62.0));
  scene.setView(ViewPreset::left);
  FieldLayer layer(scene);
  auto picture = falling();
  layer.set(&picture, 1.0);
  const RgbImage with = scene.render(400, 400);
  const auto whiteRows = [&] {
    std::vector<int> rows;
    for (int y = 0; y < with.height_px; ++y) {
      const auto* p = with.pixel(with.width_px / 2, y);
      if (std::min({p[0], p[1], p[2]}) > 200 && (rows.empty() || y > rows.back() + 3)) rows.push_back(y);
    }
    return rows;
  };
  const auto rows = whiteRows();
  ASSERT_GE(rows.size(), 3u);
  // From below: z = 0, 30 and 48 mm on a ball of 60 mm.
  const double low = rows[rows.size() - 1], middle = rows[rows.size() - 2], high = rows[rows.size() - 3];
  EXPECT_NEAR((low - middle) / (low - high), 30.0 / 48, 0.06);
}

TEST(FieldLayer, IsDrawnAndTakenAwayWhole) {
  if (!hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  NavigationScene scene;
  scene.setScalp(testing::ballMesh(90.0));
  scene.setView(ViewPreset::left);
  const RgbImage before = scene.render(400, 400);
  FieldLayer layer(scene);
  auto picture = falling();
  layer.set(&picture, 1.0);
  const int all = coloured(before, scene.render(400, 400));
  EXPECT_GT(all, 3000);
  for (float& strength : picture.strength)
    if (strength < 50) strength = 0;
  layer.set(&picture, 1.0);
  // Of the visible disc, the part above a fifth of the height is 86 %, that above half of it 50 %.
  EXPECT_NEAR(double(coloured(before, scene.render(400, 400))) / all, 0.50 / 0.86, 0.08);
  layer.set(nullptr, 1.0);
  EXPECT_EQ(coloured(before, scene.render(400, 400)), 0);
}

}  // namespace
}  // namespace facenav::scene
