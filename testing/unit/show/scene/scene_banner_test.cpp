#include "scene_banner.h"

#include <gtest/gtest.h>

#include "facenav/scene/display.h"
#include "facenav/scene/navigation_scene.h"

namespace facenav::scene {
namespace {

TEST(SceneBanner, BreaksALongTextAtItsSpaces) {
  const std::string words = "FACE LOST: turn the face towards the cameras";
  EXPECT_EQ(inLines(words, 1), "  FACE LOST: turn the face towards the cameras  ");
  EXPECT_EQ(inLines(words, 2), "  FACE LOST: turn the face  \n  towards the cameras  ");
  EXPECT_EQ(inLines(words, 3), "  FACE LOST: turn  \n  the face towards  \n  the cameras  ");
  EXPECT_EQ(inLines("COIL", 3), "  COIL  ") << "a word is never broken";
}

bool isText(const std::uint8_t* pixel) { return pixel[0] > 200 && pixel[1] > 200 && pixel[2] > 200; }

int textPixels(const RgbImage& image) {
  int n = 0;
  for (int v = 0; v < image.height_px; ++v)
    for (int u = 0; u < image.width_px; ++u) n += isText(image.pixel(u, v));
  return n;
}

/// Pixels of the banner's text alone: the head icon's letters are white, too.
int bannerPixels(NavigationScene& scene, const std::string& words, int width_px, int height_px) {
  scene.setBanner("");
  const int others = textPixels(scene.render(width_px, height_px));
  scene.setBanner(words);
  return textPixels(scene.render(width_px, height_px)) - others;
}

constexpr const char* kLong = "FACE LOST: the face is covered or turned away, turn it towards the cameras";

TEST(SceneBanner, LiesWholeInANarrowView) {
  if (!hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  NavigationScene scene;
  const int whole = bannerPixels(scene, kLong, 1600, 900);
  ASSERT_GT(whole, 2000);
  for (const auto& [width, height] : {std::pair(420, 300), std::pair(600, 260), std::pair(400, 800)})
    EXPECT_NEAR(bannerPixels(scene, kLong, width, height), whole, 0.04 * whole) << width << " x " << height;
}

// If even three lines are too wide, the letters are smaller, but complete.
TEST(SceneBanner, IsMadeSmallerOnlyWhereNoLinesFit) {
  if (!hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  NavigationScene scene;
  scene.setBanner(kLong);
  const RgbImage image = scene.render(240, 200);
  ASSERT_GT(textPixels(image), 300);
  for (int v = 0; v < image.height_px / 2; ++v)  // above the head icon
    for (const int u : {0, 1, 2, 237, 238, 239}) EXPECT_FALSE(isText(image.pixel(u, v))) << u << ", " << v;
  for (int u = 0; u < image.width_px; ++u)
    for (const int v : {0, 1}) EXPECT_FALSE(isText(image.pixel(u, v))) << u << ", " << v;
}

TEST(SceneBanner, FollowsTheTextScale) {
  if (!hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  NavigationScene scene;
  const int letters = textPixels(scene.render(2000, 900));  // of the head icon
  const int usual = bannerPixels(scene, kLong, 2000, 900);
  scene.setTextScale(2.0);
  // Four times the area, and more: thin strokes at scale 1 cover some pixels only in part.
  EXPECT_GT(bannerPixels(scene, kLong, 2000, 900), 3 * usual);
  EXPECT_LT(bannerPixels(scene, kLong, 2000, 900), 6 * usual);
  scene.setBanner("");
  EXPECT_GT(textPixels(scene.render(2000, 900)), 2.5 * letters);
}

}  // namespace
}  // namespace facenav::scene
