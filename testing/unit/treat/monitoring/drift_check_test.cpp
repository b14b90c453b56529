#include "facenav/monitoring/drift_check.h"

#include <gtest/gtest.h>

#include "facenav/geometry/rotation.h"
#include "facenav/monitoring/drift_watchdog.h"
#include "sitting.h"

namespace facenav::monitoring {
namespace {

using namespace sitting;
using Verdict = DriftFinding::Verdict;

TEST(DriftCheck, AgreesWhereTheFaceIsTrackedFromEverySide) {
  if (!hasPortrait()) GTEST_SKIP() << "python3-skimage's portrait is not installed";
  const auto& sitting = Sitting::shared();
  std::uint64_t seed = 10;
  for (const auto& turn_deg : {Eigen::Vector3d(0, 0, 0), {0, 22, 0}, {12, -18, 8}}) {
    SyntheticView view;
    view.motion = sitting.about(turn_deg, {8, -6, 20});
    view.seed = ++seed;
    view.gain = 0.8;
    const auto found = sitting.measure(sitting.render(view), view.motion);
    EXPECT_EQ(found.verdict, Verdict::agrees) << turn_deg.transpose();
    EXPECT_LT(found.shift_mm, 3 * found.shift_sigma_mm) << turn_deg.transpose();
    EXPECT_LT(found.turn_deg, 3 * found.turn_sigma_deg) << turn_deg.transpose();
  }
}

TEST(DriftCheck, SeesADriftOf3MillimetresOr2Point2DegreesAlongEachAxis) {
  if (!hasPortrait()) GTEST_SKIP() << "python3-skimage's portrait is not installed";
  const auto& sitting = Sitting::shared();
  SyntheticView view;
  view.motion = sitting.about({4, 10, -3}, {10, 5, -8});
  view.seed = 20;
  const auto frame = sitting.render(view);
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      const Eigen::Vector3d along = sign * Eigen::Vector3d::Unit(axis);
      const auto shifted = sitting.measure(frame, sitting.about({0, 0, 0}, 3.0 * along) * view.motion);
      EXPECT_EQ(shifted.verdict, Verdict::drifted) << along.transpose() << ": " << shifted.shift_mm << " mm";
      const Eigen::Isometry3d turned = view.motion * sitting.about(2.2 * along, {0, 0, 0});
      const auto found = sitting.measure(frame, turned);
      EXPECT_EQ(found.verdict, Verdict::drifted) << along.transpose() << ": " << found.turn_deg << " deg";
    }
}

TEST(DriftCheck, SeesThatTheHeadMovedBetweenItsAlignmentAndTheReferencePicture) {
  if (!hasPortrait()) GTEST_SKIP() << "python3-skimage's portrait is not installed";
  const auto& sitting = Sitting::shared();
  SyntheticView view;
  view.seed = 31;
  const auto still = sitting.atReference(view);
  EXPECT_EQ(still.verdict, Verdict::agrees) << still.shift_mm << " mm, " << still.turn_deg << " deg";
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      view.motion = sitting.about({0, 0, 0}, 2.0 * sign * Eigen::Vector3d::Unit(axis));
      const auto moved = sitting.atReference(view);
      EXPECT_EQ(moved.verdict, Verdict::drifted) << axis << ": " << moved.shift_mm << " mm";
      EXPECT_NEAR(moved.shift_mm, 2.0, 0.5);
    }
}

TEST(DriftCheck, KnowsNothingOfAFaceThatItCannotSee) {
  if (!hasPortrait()) GTEST_SKIP() << "python3-skimage's portrait is not installed";
  const auto& sitting = Sitting::shared();
  SyntheticView view;
  auto frame = sitting.render(view);
  auto far = sitting.about({0, 0, 0}, {900, 0, 0});  // outside the image
  EXPECT_EQ(sitting.measure(frame, far).verdict, Verdict::unknown);
  frame.left.setTo(0);
  frame.right.setTo(0);
  EXPECT_EQ(sitting.measure(frame, Eigen::Isometry3d::Identity()).verdict, Verdict::unknown);
}

}  // namespace
}  // namespace facenav::monitoring
