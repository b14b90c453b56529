#include "brain_checks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "facenav/core/error.h"

// Balls of known volume as brains.

namespace facenav::segmentation {
namespace {

/// Ball well within a grid of voxels of 3 mm.
volume::Mask ballOf_ml(double ml) {
  volume::VoxelGrid grid;
  grid.size = {80, 80, 80};
  grid.mri_from_voxel = Eigen::Scaling(3.0);
  return ballOf(grid, Eigen::Vector3d::Constant(120), std::cbrt(ml * 1e3 * 3 / (4 * M_PI)));
}

BetSphere headOf_ml(double ml) { return {Eigen::Vector3d::Zero(), std::cbrt(ml * 1e3 * 3 / (4 * M_PI))}; }

TEST(BrainChecks, RefusesVolumesThatNoBrainHas) {
  EXPECT_THROW(checkBrain(ballOf_ml(500), headOf_ml(1400)), Error);
  EXPECT_THROW(checkBrain(ballOf_ml(2300), headOf_ml(1400)), Error);
  EXPECT_THROW(checkBrain(ballOf_ml(2700), headOf_ml(4000)), Error);
}

TEST(BrainChecks, GrantsABrainThatFillsALargeHead) {
  EXPECT_NO_THROW(checkBrain(ballOf_ml(2250), headOf_ml(1840)));  // 1.22 of the ball by the head
}

TEST(BrainChecks, GrantsMoreToAHeadThatIsItselfLarge) {
  EXPECT_NO_THROW(checkBrain(ballOf_ml(2300), headOf_ml(2350)));
}

TEST(BrainChecks, HasNothingToSayOfAnAdultsBrain) {
  EXPECT_TRUE(checkBrain(ballOf_ml(1400), headOf_ml(1400)).empty());
}

}  // namespace
}  // namespace facenav::segmentation
