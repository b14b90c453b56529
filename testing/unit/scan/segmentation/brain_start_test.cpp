#include "brain_start.h"

#include <gtest/gtest.h>

#include "head_phantom.h"

namespace facenav::segmentation {
namespace {

TEST(BrainStart, IsTheBrainsOwnWhereverTheFirstBallLay) {
  testing::PhantomOptions options;
  options.spacing_mm = 2.0;
  const volume::Volume coarse = workingVolume(testing::makeHeadPhantom(options).volume, 2.0);
  const BrainStart by_head = findBrainStart(coarse);
  TaskMonitor monitor;
  const auto from = [&](const Eigen::Vector3d& shift_mm, double larger_mm) {
    BrainStart start = by_head;
    start.sphere.centre_mm += shift_mm;
    start.sphere.radius_mm += larger_mm;
    return centredOnBrain(coarse, start, 0.45, monitor);
  };
  const BrainStart here = from(Eigen::Vector3d::Zero(), 0);
  // Rotations of 20 degrees move the ball by this much, by its top and girth; a third of it may remain.
  const Eigen::Vector3d shift_mm(4, -9, -6);
  for (double side : {-1.0, 1.0}) {
    const BrainStart there = from(side * shift_mm, side * 3);
    EXPECT_LT((there.sphere.centre_mm - here.sphere.centre_mm).norm(), shift_mm.norm() / 3);
    EXPECT_NEAR(there.sphere.radius_mm, here.sphere.radius_mm, 1);
    EXPECT_NEAR(there.intensities.median, here.intensities.median, 0.02 * here.intensities.median);
  }
}

}  // namespace
}  // namespace facenav::segmentation
