#include "facenav/align/alignment_seen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/ball_mesh.h"
#include "support/stereo_scene.h"

namespace facenav::steps {
namespace {

using ::testing::HasSubstr;
constexpr double kBallRadius_mm = 90;

/// Ball of 90 mm before the cameras. The MRI is aligned, or 4 mm beside it along the line of sight.
class PickedSpotOnSkin : public ::testing::Test {
 protected:
  session::NavigationState state(double off_mm) const {
    session::NavigationState state;
    state.images = std::make_shared<const cameras::StereoFrame>(
        testing::Scene(testing::sphere({0, 0, 620}, kBallRadius_mm), {}).render(rig_));
    state.camera_T_mri = {
        RigidTransform<Camera, Mri>(Eigen::Quaterniond::Identity(), Eigen::Vector3d(0, 0, 620 + off_mm)),
        0.9};
    return state;
  }
  std::optional<guidance::TipReading> read(const session::NavigationState& state,
                                           const Eigen::Vector3d& place_mm) const {
    return readPickedSpot(state, rig_, stereo::PictureSide::left, cameras::project(rig_.left, place_mm),
                          check_);
  }
  const cameras::StereoRig rig_ = testing::convergingRig();
  const guidance::TipCheck check_{testing::ballMesh(kBallRadius_mm),
                                  {{"nose tip", Point<Mri>(0, 0, -kBallRadius_mm), 1.0}}};
  const Eigen::Vector3d front_mm_{0, 0, 620 - kBallRadius_mm};
};

TEST_F(PickedSpotOnSkin, LiesOnTheSkinAndNearItsPlace) {
  const auto reading = read(state(0), front_mm_);
  ASSERT_TRUE(reading);
  EXPECT_NEAR(reading->off_skin_mm, 0, 0.5);
  EXPECT_LT(reading->off_place_mm, 0.5);
  EXPECT_EQ(reading->what, guidance::TipReading::What::picked_spot);
  EXPECT_GT(reading->sigma_mm, 0);
  EXPECT_THAT(inWords(TipVerdict::right, *reading), HasSubstr("; picked spot at ("));
}

TEST_F(PickedSpotOnSkin, AWrongAlignmentShowsInItsFigures) {
  const auto reading = read(state(4), front_mm_);
  ASSERT_TRUE(reading);
  EXPECT_NEAR(reading->off_skin_mm, 4, 0.5);
  EXPECT_NEAR(reading->off_place_mm, 4, 0.5);
}

TEST_F(PickedSpotOnSkin, NothingWithoutAPoseOrAfterACameraMovedOrBesideTheHead) {
  auto lost = state(0);
  lost.camera_T_mri = Lost{LostReason::no_face};
  EXPECT_FALSE(read(lost, front_mm_));
  auto moved = state(0);
  moved.rig_correction = health::CorrectedMotion{0.3};
  EXPECT_FALSE(read(moved, front_mm_));
  EXPECT_FALSE(read(state(0), {-250, 0, 620})) << "no skin there";
}

}  // namespace
}  // namespace facenav::steps
