#include "facenav/guidance/instruction.h"

#include <gtest/gtest.h>

#include "made_targets.h"

namespace facenav::guidance {
namespace {
using namespace guidance::testing;

std::string wordsAt(const Target& target, const Eigen::Vector3d& mri_shift_mm,
                    const Eigen::Matrix3d& rotation_in_coil = Eigen::Matrix3d::Identity()) {
  const Eigen::Vector3d shift_mm = target.mri_T_target.rotation().transpose() * mri_shift_mm;
  return instruct(target, evaluate(target, coilAt(target, shift_mm, rotation_in_coil)), {}).words;
}

TEST(Instruction, MovesOppositeToTheOffsetInThePatientsWords) {
  const Target target = vertexTarget();
  EXPECT_EQ(wordsAt(target, {3, 0, 0}), "move 3 mm to the patient's left");  // the coil is too far right
  EXPECT_EQ(wordsAt(target, {-7, 0, 0}), "move 7 mm to the patient's right");
  EXPECT_EQ(wordsAt(target, {0, -4, 0}), "move 4 mm towards the face");
  EXPECT_EQ(wordsAt(target, {0, 6.2, 0}), "move 6 mm towards the back of the head");
}

TEST(Instruction, SaysUpAndDownOverTheSideOfTheHead) {
  Target target = vertexTarget();
  target.mri_T_target = poseFrom<frames::Target>({-75, 0, 20}, {1, 0, 0}, {0, 1, 0});
  EXPECT_EQ(wordsAt(target, {0, 0, -5}), "move 5 mm up, towards the top of the head");
  EXPECT_EQ(wordsAt(target, {0, 0, 5}), "move 5 mm down, towards the neck");
}

TEST(Instruction, TellsStandingOffFromPressingIn) {
  const Target target = vertexTarget();
  EXPECT_EQ(wordsAt(target, {0, 0, 8}), "press 8 mm closer");
  EXPECT_EQ(wordsAt(target, {0, 0, -5}), "lift the coil 5 mm");
}

// Seen from above with the handle towards the viewer: +y away from the viewer, z down into the head, so +x is
// left.
TEST(Instruction, TiltsAndTurnsTheCoilTheRightWay) {
  const Target target = vertexTarget();
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                        z = Eigen::Vector3d::UnitZ();
  // A positive rotation about x moves the front (+y) into the head and lifts the handle, so the handle must
  // go down.
  EXPECT_EQ(wordsAt(target, {0, 0, 0}, about(x, 8)), "tilt the handle side down 8°");
  EXPECT_EQ(wordsAt(target, {0, 0, 0}, about(x, -8)), "tilt the handle side up 8°");
  // A positive rotation about y lifts +x, the left wing.
  EXPECT_EQ(wordsAt(target, {0, 0, 0}, about(y, 9)), "tilt the left wing down 9°");
  EXPECT_EQ(wordsAt(target, {0, 0, 0}, about(y, -9)), "tilt the left wing up 9°");
  // A positive rotation about z, which points away from a person above the coil, is clockwise for that
  // person.
  EXPECT_EQ(wordsAt(target, {0, 0, 0}, about(z, 15)), "turn counterclockwise seen from above the coil 15°");
  EXPECT_EQ(wordsAt(target, {0, 0, 0}, about(z, -15)), "turn clockwise seen from above the coil 15°");
}

TEST(Instruction, PutsTheWorstFirstInUnitsOfItsTolerance) {
  const Target target = vertexTarget();
  const Eigen::Matrix3d turned = about(Eigen::Vector3d::UnitZ(), 20);  // twice its tolerance
  EXPECT_EQ(wordsAt(target, {3, 0, 0}, turned).substr(0, 4), "turn");
  EXPECT_EQ(wordsAt(target, {6, 0, 0}, turned).substr(0, 4), "move");
}

TEST(Instruction, HoldsInsideAllTolerancesOnly) {
  const Target target = vertexTarget();
  EXPECT_EQ(wordsAt(target, {1.9, 0, 0}), "hold");
  EXPECT_NE(wordsAt(target, {2.1, 0, 0}), "hold");
  EXPECT_NE(wordsAt(target, {0, 0, 3.1}), "hold");
  EXPECT_NE(wordsAt(target, {0, 0, 0}, about(Eigen::Vector3d::UnitX(), 5.1)), "hold");
  EXPECT_NE(wordsAt(target, {0, 0, 0}, about(Eigen::Vector3d::UnitZ(), 10.1)), "hold");
}

TEST(Instruction, DoesNotFlickerAtALimit) {
  const Target target = vertexTarget();
  const GuidanceValues just_outside = evaluate(target, coilAt(target, {2.2, 0, 0}));
  EXPECT_EQ(instruct(target, just_outside, {}, Action::hold).action, Action::hold);
  EXPECT_EQ(instruct(target, just_outside, {}, Action::move).action, Action::move);
  const GuidanceValues well_outside = evaluate(target, coilAt(target, {2.6, 0, 0}));
  EXPECT_EQ(instruct(target, well_outside, {}, Action::hold).action, Action::move);
  const GuidanceValues near_tie =
      evaluate(target, coilAt(target, {4.4, 0, 0}, about(Eigen::Vector3d::UnitZ(), 20)));
  EXPECT_EQ(instruct(target, near_tie, {}, Action::turn).action, Action::turn);
  EXPECT_EQ(instruct(target, near_tie, {}, Action::none).action, Action::move);
}

TEST(Instruction, FollowedToTheEndReachesTheTarget) {
  const Target target = vertexTarget();
  Eigen::Vector3d offset_mm(23, -14, -30);
  int steps = 0;
  for (; steps < 20; ++steps) {  // follows the instruction along its direction
    const GuidanceValues values = evaluate(target, coilAt(target, offset_mm));
    const Instruction said = instruct(target, values, {});
    if (said.action == Action::hold) break;
    if (said.action == Action::press || said.action == Action::lift) offset_mm.z() = 0;
    if (said.action == Action::move) offset_mm[std::abs(offset_mm.x()) > std::abs(offset_mm.y()) ? 0 : 1] = 0;
  }
  EXPECT_LE(steps, 4);
}

}  // namespace
}  // namespace facenav::guidance
