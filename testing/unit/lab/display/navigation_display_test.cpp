#include "facenav/display/navigation_display.h"

#include <gtest/gtest.h>

#include "facenav/scene/display.h"
#include "support/ball_mesh.h"

namespace facenav::display {
namespace {

guidance::Target topTarget() {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();  // z down into the head, y anterior, x = y cross z = left
  m.block<3, 3>(0, 0) << -1, 0, 0, 0, 1, 0, 0, 0, -1;
  m(2, 3) = 100.0;
  guidance::Target target;
  target.name = "vertex";
  target.mri_T_target = RigidTransform<Mri, Target>::fromMatrix(m);
  target.cortex_point = Point<Mri>(0, 0, 80);
  target.scalp_point = Point<Mri>(0, 0, 100);
  return target;
}

TEST(NavigationDisplay, BlanksTheFiguresWhenLost) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  scene::NavigationScene scene;
  scene.setScalp(testing::ballMesh(100, 40, 60));
  scene.setTargets({topTarget()}, "vertex");
  scene.setView(scene::ViewPreset::target);
  NavigationDisplay display(scene, 640, 360);
  NavigationDisplayContent content;
  content.guidance.state = guidance::State::lost;
  content.guidance.values =  // set, but must not be drawn
      guidance::evaluate(topTarget(), topTarget().mri_T_target.reframe<Mri, Coil>());
  content.guidance.instruction = "COIL LOST";
  const RgbImage lost = display.render(content);
  content.guidance.values.reset();
  const RgbImage without = display.render(content);
  ASSERT_EQ(lost.rgb.size(), 640u * 360 * 3);
  EXPECT_EQ(lost.rgb, without.rgb);
}

}  // namespace
}  // namespace facenav::display
