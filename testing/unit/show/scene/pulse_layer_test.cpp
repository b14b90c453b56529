#include "facenav/scene/pulse_layer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "facenav/scene/display.h"
#include "support/ball_mesh.h"

namespace facenav::scene {
namespace {

/// CIE lightness of an sRGB colour, 0..100.
double lightness(const palette::Rgb& colour) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  const double y = 0.2126 * linear(colour[0]) + 0.7152 * linear(colour[1]) + 0.0722 * linear(colour[2]);
  return y > 0.008856 ? 116.0 * std::cbrt(y) - 16.0 : 903.3 * y;
}

TEST(SequentialColour, GetsLighterThroughoutAndHoldsItsEnds) {
  double before = lightness(sequentialColour(0.0));
  EXPECT_LT(before, 35);
  for (int i = 1; i <= 100; ++i) {
    const double now = lightness(sequentialColour(i / 100.0));
    EXPECT_GT(now, before) << i;
    EXPECT_LT(now - before, 2.0) << i << ": no step that looks like an edge";
    before = now;
  }
  EXPECT_GT(before, 90);
  EXPECT_EQ(sequentialColour(-3), sequentialColour(0));
  EXPECT_EQ(sequentialColour(7), sequentialColour(1));
}

TEST(ColourRange, EqualEndsGiveTheMiddle) {
  EXPECT_DOUBLE_EQ((ColourRange{2, 6}.shareOf(3)), 0.25);
  EXPECT_DOUBLE_EQ((ColourRange{2, 2}.shareOf(2)), 0.5);
}

/// Number of pixels that differ by more than noise.
int differing(const RgbImage& a, const RgbImage& b) {
  int n = 0;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3)
    n += std::abs(a.rgb[i] - b.rgb[i]) + std::abs(a.rgb[i + 1] - b.rgb[i + 1]) +
             std::abs(a.rgb[i + 2] - b.rgb[i + 2]) >
         24;
  return n;
}

/// View from above; the coil is 5 mm over the top of a ball of 90 mm, facing down.
class PulseLayerTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
    scene_ = std::make_unique<NavigationScene>();
    scene_->setScalp(testing::ballMesh(90.0));
    scene_->setView(ViewPreset::top);
  }
  RgbImage render() { return scene_->render(400, 400); }
  static PulseMark markAt(double x_mm, double y_mm, const palette::Rgb& colour) {
    PulseMark mark;
    const Eigen::Quaterniond down(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()));
    mark.mri_T_coil = RigidTransform<Mri, Coil>(down, {x_mm, y_mm, 95});
    mark.colour = colour;
    return mark;
  }
  std::unique_ptr<NavigationScene> scene_;
};

TEST_F(PulseLayerTest, PulsesAreDrawnAndTakenAway) {
  PulseLayer layer(*scene_);
  const RgbImage before = render();
  layer.set({markAt(0, 0, {1, 0, 0}), markAt(20, 0, {0, 0, 1})});
  const RgbImage two = render();
  int red = 0, blue = 0;
  for (std::size_t i = 0; i < two.rgb.size(); i += 3) {
    red += two.rgb[i] > 120 && two.rgb[i + 1] < 60 && two.rgb[i + 2] < 60;
    blue += two.rgb[i + 2] > 120 && two.rgb[i] < 60 && two.rgb[i + 1] < 60;
  }
  EXPECT_GT(red, 20);
  EXPECT_NEAR(red, blue, 0.5 * red);
  layer.set({});
  EXPECT_EQ(differing(before, render()), 0);
}

TEST_F(PulseLayerTest, AnExcludedPulseIsSmallerAndAChosenOneLarger) {
  PulseLayer layer(*scene_);
  const RgbImage before = render();
  auto mark = markAt(0, 0, {1, 1, 0});
  layer.set({mark});
  const int plain = differing(before, render());
  mark.is_chosen = true;
  layer.set({mark});
  EXPECT_GT(differing(before, render()), 1.3 * plain);
  mark.is_chosen = false, mark.is_excluded = true;
  layer.set({mark});
  const int excluded = differing(before, render());
  EXPECT_GT(excluded, 0);
  EXPECT_LT(excluded, 0.7 * plain);
}

TEST_F(PulseLayerTest, HeatIsDrawnOnlyWhereTheMapHasAValue) {
  PulseLayer layer(*scene_);
  const auto brain = testing::ballMesh(60.0);
  std::vector<float> top, everywhere;
  for (const auto& p_mm : brain.vertices_mm) {
    everywhere.push_back(1.0f);
    top.push_back(p_mm.z() > 57 ? 1.0f : std::numeric_limits<float>::quiet_NaN());
  }
  const RgbImage before = render();
  layer.setHeat(brain, top, {0, 1});
  const int few = differing(before, render());
  layer.setHeat(brain, everywhere, {0, 1});
  const int all = differing(before, render());
  EXPECT_GT(few, 50);
  // From above, the cap's radius is sqrt(60^2 - 57^2) = 18.7 mm of 60: a tenth of the disc.
  EXPECT_NEAR(double(few) / all, 0.1, 0.05);
  layer.clearHeat();
  EXPECT_EQ(differing(before, render()), 0);
}

}  // namespace
}  // namespace facenav::scene
