#include "facenav/pictures/camera_overlay.h"

#include <gtest/gtest.h>

#include "unit/treat/session/session_fakes.h"

namespace facenav::pictures {
namespace {

namespace fakes = session::fakes;

session::NavigationState trackedState() {
  auto navigator = session::Navigator(
      fakes::setup(), std::make_unique<fakes::Head>([](auto) { return RigidTransform<Camera, Head>(); }),
      std::make_unique<fakes::Coil>(
          RigidTransform<Camera, Marker>(Eigen::Quaterniond::Identity(), {0, 0, 500})));
  return navigator.process(fakes::frame(0, 0));
}

int colouredPixels(const RgbImage& image, int v_from) {
  int n = 0;
  for (int v = v_from; v < image.height_px; ++v)
    for (int u = 0; u < image.width_px; ++u) n += std::abs(image.pixel(u, v)[0] - image.pixel(u, v)[2]) > 30;
  return n;
}

TEST(CameraOverlay, OutlinesTheMarkerInBothImages) {
  const auto overlay = drawOverlay(fakes::rig(), trackedState());
  ASSERT_EQ(overlay.left.width_px, 64);
  ASSERT_EQ(overlay.right.height_px, 48);
  for (const RgbImage* image : {&overlay.left, &overlay.right})
    EXPECT_GT(image->pixel(30, 30)[0], image->pixel(30, 30)[2] + 60);  // orange on the outline's lower edge
}

TEST(CameraOverlay, DrawsNothingOfALostPose) {
  const auto overlay = drawOverlay(fakes::rig(), session::blanked(trackedState(), LostReason::stale));
  EXPECT_EQ(colouredPixels(overlay.left, 20), 0);  // below the caption
  EXPECT_EQ(colouredPixels(overlay.right, 20), 0);
}

TEST(CameraOverlay, IsEmptyWithoutImages) { EXPECT_TRUE(drawOverlay(fakes::rig(), {}).left.empty()); }

}  // namespace
}  // namespace facenav::pictures
