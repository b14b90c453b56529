#include "facenav/pictures/burnt_plan.h"

#include <gmock/gmock.h>

#include "facenav/core/error.h"

namespace facenav::testing {
namespace {

/// Grey 500 in a head of voxels of 1 mm; a tenth of the voxels are bright, so that the window reaches 1000.
volume::Volume greyHead() {
  volume::Volume mri;
  mri.grid.size = {160, 160, 60};
  mri.grid.mri_from_voxel.translation() = Eigen::Vector3d(-80, -80, -30);
  mri.voxels.assign(mri.grid.count(), 500.f);
  for (std::size_t v = 0; v < mri.voxels.size(); ++v)
    if (v % 10 == 0) mri.voxels[v] = v % 20 == 0 ? 1000.f : 0.f;
  return mri;
}

/// A coil on top of the place (-30, 20, 0), 25 mm above it.
guidance::Target targetAt() {
  guidance::Target target;
  target.name = "M1 hand L";
  target.cortex_point = Point<Mri>(-30, 20, 0);
  target.scalp_point = Point<Mri>(-30, 20, 20);
  target.mri_T_target = {Eigen::Quaterniond(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX())),
                         Eigen::Vector3d(-30, 20, 25)};
  return target;
}

guidance::CoilPlate smallPlate() { return {{{-20, -10}, {20, -10}, {20, 10}, {-20, 10}}}; }

class BurntPlanTest : public ::testing::Test {
 protected:
  float at(double x, double y, double z) const {
    return *volume::valueAt(burnt_.volume, Point<Mri>(x, y, z));
  }
  const volume::Volume mri_ = greyHead();
  const pictures::BurntPlan burnt_ = pictures::burnPlan(mri_, {targetAt()}, smallPlate());
};

TEST_F(BurntPlanTest, ACrossStandsRoundThePlaceAndLeavesItVisible) {
  EXPECT_EQ(burnt_.white, 1000);
  EXPECT_EQ(burnt_.black, 0);
  for (const double side : {-1.0, 1.0}) {
    EXPECT_EQ(at(-30 + side * 8, 20, 0), burnt_.white);
    EXPECT_EQ(at(-30, 20 + side * 8, 0), burnt_.white);
    EXPECT_EQ(at(-30 + side * 8, 21, 0), burnt_.black) << "the mark's edge";
  }
  EXPECT_EQ(at(-30, 20, -8), burnt_.white);
  for (const double off : {-1.0, 0.0, 1.0}) {
    const Point<Mri> p(-30 + off, 20 - off, 0);
    EXPECT_EQ(*volume::valueAt(burnt_.volume, p), *volume::valueAt(mri_, p));
  }
  EXPECT_NE(at(30 + 8, 20, 0), burnt_.white) << "nothing on the right side";
}

TEST_F(BurntPlanTest, TheCoilLiesInItsPlaneAtItsPose) {
  for (const double x : {-50.0, -30.0, -10.0})
    for (const double y : {10.0, 30.0}) EXPECT_EQ(at(x, y, 25), burnt_.white) << x << " " << y;
  // The pose is turned half round x: the handle, along -y of the coil, points to +y.
  EXPECT_EQ(at(-30, 70, 25), burnt_.white);
  EXPECT_NE(at(-30, -30, 25), burnt_.white);
  EXPECT_EQ(at(-30, 20, 24), burnt_.white) << "the axis begins at the coil";
}

TEST_F(BurntPlanTest, EachSliceSaysThatItIsNotForDiagnosis) {
  const auto& size = mri_.grid.size;
  for (int k = 0; k < size[2]; ++k) {
    int white = 0;
    for (int j = size[1] - 20; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i)
        white += burnt_.volume.at(i, j, k) == burnt_.white && mri_.at(i, j, k) != burnt_.white;
    ASSERT_GT(white, 100) << "slice " << k;
  }
}

TEST_F(BurntPlanTest, TheNameStandsOnTheSlicesOfTheTargetOnly) {
  const auto whiteBeside = [&](int k) {
    int white = 0;
    for (int j = 85; j < 105; ++j)
      for (int i = 68; i < 140; ++i) white += burnt_.volume.at(i, j, k) != mri_.at(i, j, k);
    return white;
  };
  EXPECT_GT(whiteBeside(30), 100);
  EXPECT_EQ(whiteBeside(45), 0);
}

TEST(BurntPlan, MasksCoverTheSamePlaces) {
  const auto mri = greyHead();
  const auto masks = pictures::planMasks(mri.grid, {targetAt()}, smallPlate());
  ASSERT_EQ(masks.size(), 2u);
  EXPECT_EQ(masks[0].label, "M1 hand L");
  EXPECT_NEAR(masks[0].mask.volume_ml(), 4.0 / 3 * M_PI * 0.125, 0.03);
  EXPECT_TRUE(masks[0].mask.at(50, 100, 30));
  EXPECT_TRUE(masks[1].is_coil);
  EXPECT_TRUE(masks[1].mask.at(30, 90, 55)) << "a corner of the plate";
  EXPECT_FALSE(masks[1].mask.at(50, 100, 30));
}

TEST(BurntPlan, APlaceOutsideTheScanIsRefused) {
  auto target = targetAt();
  target.cortex_point = Point<Mri>(-30, 20, 31);
  EXPECT_THROW(pictures::burnPlan(greyHead(), {target}, smallPlate()), Error);
}

}  // namespace
}  // namespace facenav::testing
