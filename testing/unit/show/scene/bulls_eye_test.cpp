// The bull's eye: the directions in which the cross, the tilt's line and the twist's tick move. The pictures
// are measured in mm (200 px are 1.18 * 20 mm) and compared with the coil's true offset from the target.

#include "facenav/scene/bulls_eye.h"

#include <gtest/gtest.h>

#include <cmath>

#include "facenav/geometry/rotation.h"
#include "facenav/scene/display.h"
#include "support/matchers.h"

namespace facenav::scene {
namespace {

using testing::EigenNear;
constexpr int kEyeSide_px = 400;
constexpr double kPxPerMm = 0.5 * kEyeSide_px / (1.18 * 20.0);

guidance::GuidanceState guided(const Eigen::Vector3d& offset_mm, const Eigen::Vector3d& turn_deg,
                               guidance::State state = guidance::State::adjust) {
  guidance::Target target;
  target.cortex_point = Point<Mri>(0, 0, 20);
  const RigidTransform<Mri, Coil> coil(Eigen::Quaterniond(expRotation(turn_deg * M_PI / 180)), offset_mm);
  guidance::GuidanceState result;
  result.state = state;
  result.values = guidance::evaluate(target, coil);
  return result;
}

bool isText(const std::uint8_t* p) { return p[0] > 215 && p[1] > 215 && p[2] > 215; }

class BullsEyeTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
    bulls_eye_ = std::make_unique<BullsEye>();
  }
  /// Mean place (mm, x right, y up) of the coil's marks between two radii from the dial's centre.
  Eigen::Vector2d marks(const guidance::GuidanceState& state, double from_mm, double to_mm) {
    bulls_eye_->set(state);
    const RgbImage image = bulls_eye_->render(kEyeSide_px, kEyeSide_px);
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    count_ = 0;
    for (int v = 0; v < kEyeSide_px; ++v)
      for (int u = 0; u < kEyeSide_px; ++u) {
        const Eigen::Vector2d p((u + 0.5 - 200) / kPxPerMm, (200 - v - 0.5) / kPxPerMm);
        if (p.norm() < from_mm || p.norm() > to_mm || !isText(image.pixel(u, v))) continue;
        sum += p, ++count_;
      }
    return count_ ? Eigen::Vector2d(sum / count_) : sum;
  }
  std::unique_ptr<BullsEye> bulls_eye_;
  int count_ = 0;
};

TEST_F(BullsEyeTest, TheCrossStandsWhereTheCoilIsSeenAlongItsAxis) {
  EXPECT_THAT(marks(guided({0, 0, 0}, {0, 0, 0}), 0, 17), EigenNear(Eigen::Vector2d(0, 0), 0.15));
  EXPECT_THAT(marks(guided({6, 0, 0}, {0, 0, 0}), 0, 17), EigenNear(Eigen::Vector2d(-6, 0), 0.2))
      << "along +z, +x points to the left";
  EXPECT_THAT(marks(guided({0, 6, 0}, {0, 0, 0}), 0, 17), EigenNear(Eigen::Vector2d(0, 6), 0.2))
      << "+y is up";
  EXPECT_THAT(marks(guided({-5, -4, 0}, {0, 0, 0}), 0, 17), EigenNear(Eigen::Vector2d(5, -4), 0.2));
}

TEST_F(BullsEyeTest, DepthAloneDoesNotMoveTheCross) {
  EXPECT_THAT(marks(guided({0, 0, -9}, {0, 0, 0}), 0, 17), EigenNear(Eigen::Vector2d(0, 0), 0.15));
}

TEST_F(BullsEyeTest, TheTiltsLineIsAMillimetrePerDegreeToWhereTheAxisLeans) {
  // A turn by +10 deg about x leans z to -y: down, 10 mm. Beyond the cross (5 mm) only the line's end is
  // seen.
  const Eigen::Vector2d down = marks(guided({0, 0, 0}, {10, 0, 0}), 9.0, 12.0);
  ASSERT_GT(count_, 20);
  EXPECT_NEAR(down.x(), 0.0, 0.2);
  EXPECT_NEAR(down.y(), -10.0, 0.7);
  // A turn about y leans z to +x: to the left.
  const Eigen::Vector2d left = marks(guided({0, 0, 0}, {0, 10, 0}), 9.0, 12.0);
  ASSERT_GT(count_, 20);
  EXPECT_NEAR(left.x(), -10.0, 0.7);
  EXPECT_NEAR(left.y(), 0.0, 0.2);
}

TEST_F(BullsEyeTest, TheTwistsTickTurnsWithTheHandle) {
  for (const double deg : {0.0, 30.0, -50.0, 120.0}) {
    const Eigen::Vector2d tick = marks(guided({0, 0, 0}, {0, 0, deg}), 18.0, 23.0);
    ASSERT_GT(count_, 20) << deg;
    // The coil's y after the turn is (-sin, cos) in the target; its x points to the left on the screen.
    const Eigen::Vector2d expected(std::sin(deg * M_PI / 180), std::cos(deg * M_PI / 180));
    EXPECT_THAT(tick.normalized(), EigenNear(expected, 0.03)) << deg;
  }
}

TEST_F(BullsEyeTest, BeyondItsRangeTheCrossStaysAtTheEdge) {
  const Eigen::Vector2d far = marks(guided({-200, 0, 0}, {0, 0, 0}), 0, 30);
  ASSERT_GT(count_, 20);
  EXPECT_GT(far.x(), 12.0);
  EXPECT_LT(far.x(), 21.0);
}

TEST_F(BullsEyeTest, TheCentreIsOrangeThenBlueAndGreyWhenLost) {
  const auto centre = [&](const guidance::GuidanceState& state) {
    bulls_eye_->set(state);
    const RgbImage image = bulls_eye_->render(kEyeSide_px, kEyeSide_px);
    const auto* p = image.pixel(kEyeSide_px / 2, kEyeSide_px / 2);
    return int(p[0]) - int(p[2]);
  };
  EXPECT_GT(centre(guided({8, 0, 0}, {0, 0, 0})), 80);
  EXPECT_LT(centre(guided({8, 0, 0}, {0, 0, 0}, guidance::State::on_target)), -80);
  EXPECT_LT(std::abs(centre(guided({8, 0, 0}, {0, 0, 0}, guidance::State::lost))), 40)
      << "values of a lost pose are not drawn";
  marks(guided({8, 0, 0}, {0, 0, 0}, guidance::State::lost), 0, 30);
  EXPECT_EQ(count_, 0);
}

TEST_F(BullsEyeTest, TheZoneHasTheTolerancesSize) {
  const auto zone_mm = [&](double lateral_mm) {
    guidance::Tolerance tolerance;
    tolerance.lateral_mm = lateral_mm;
    bulls_eye_->setTolerance(tolerance);
    bulls_eye_->set(guided({0, 15, 0}, {0, 0, 0}));  // the cross is out of the way
    const RgbImage image = bulls_eye_->render(kEyeSide_px, kEyeSide_px);
    int orange = 0;
    for (int u = 0; u < kEyeSide_px / 2; ++u) {
      const auto* p = image.pixel(u, kEyeSide_px / 2 + 8);  // a line below the centre, left of the tick
      orange += p[0] - p[2] > 25 && (kEyeSide_px / 2 - u) / kPxPerMm < 17;
    }
    return std::hypot(orange / kPxPerMm, 8.5 / kPxPerMm);
  };
  EXPECT_NEAR(zone_mm(4.0), 4.0, 0.2);
  EXPECT_NEAR(zone_mm(8.0), 8.0, 0.2);
}

}  // namespace
}  // namespace facenav::scene
