#include "facenav/guidance/hand_knob.h"

#include <gtest/gtest.h>

#include "facenav/core/error.h"
#include "facenav/volume/nifti.h"
#include "made_targets.h"
#include "support/matchers.h"
#include "support/test_data.h"

namespace facenav::guidance {
namespace {
using facenav::testing::EigenNear;

TEST(HandKnobGuess, IsTheMniPointOnColin27) {
  FACENAV_NEEDS(facenav::testing::colin27Brain());
  const volume::Volume bet = volume::readNifti(facenav::testing::colin27Brain()).volume;
  volume::Mask brain{bet.grid, {}};
  for (const float value : bet.voxels) brain.voxels.push_back(value > 0);
  EXPECT_THAT(handKnobGuess(brain, Side::left).mm, EigenNear(Eigen::Vector3d(-37, -21, 58), 1.0));
  EXPECT_THAT(handKnobGuess(brain, Side::right).mm, EigenNear(Eigen::Vector3d(36, -21, 58), 1.0));
}

TEST(HandKnobGuess, ScalesWithTheBrainAndLiesOnItsSurface) {
  surface::BrainModel brain;
  brain.mesh = guidance::testing::sphere({5, 10, 20}, 70);
  const Point<Mri> left = handKnobGuess(brain, Side::left), right = handKnobGuess(brain, Side::right);
  EXPECT_NEAR((left.mm - Eigen::Vector3d(5, 10, 20)).norm(), 70, 1e-6);
  EXPECT_LT(left.mm.x(), 5 - 30);
  EXPECT_GT(left.mm.z(), 20 + 30);
  EXPECT_NEAR(left.mm.x() + right.mm.x(), 10, 3.0);  // mirrored at the brain's middle; tolerance: one vertex
}

TEST(HandKnobGuess, RefusesAnEmptyBrain) {
  EXPECT_THROW(handKnobGuess(surface::BrainModel{}, Side::left), Error);
  EXPECT_THROW(handKnobGuess(volume::Mask{}, Side::left), Error);
}

}  // namespace
}  // namespace facenav::guidance
