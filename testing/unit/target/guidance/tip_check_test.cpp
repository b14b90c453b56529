// The coil's tip on the MRI's skin: distances on balls of known size.

#include "facenav/guidance/tip_check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "facenav/core/error.h"
#include "support/ball_mesh.h"

namespace facenav::guidance {
namespace {

TipCheck checkOnBall() {
  return TipCheck(testing::ballMesh(90, 240, 320),
                  {{"nose tip", Point<Mri>(0, 90, 0), 1.0}, {"left tragus", Point<Mri>(-90, 0, 0), 3.0}});
}

TEST(TipCheck, ATipOutsideIsItsHeightAwayFromTheSkin) {
  const auto reading = checkOnBall().read(Point<Mri>(0, 92.5, 0));
  EXPECT_NEAR(reading.off_skin_mm, 2.5, 0.05);
  ASSERT_TRUE(reading.nearest);
  EXPECT_EQ(reading.nearest->name, "nose tip");
  EXPECT_NEAR(reading.off_place_mm, 2.5, 1e-9);
  EXPECT_EQ(inWords(reading), "2.5 mm outside the skin, 2.5 mm from nose tip");
}

TEST(TipCheck, ATipInsideTheHeadIsSaidToBeInside) {
  const auto reading = checkOnBall().read(Point<Mri>(-85.4, 0, 2));
  EXPECT_NEAR(reading.off_skin_mm, std::hypot(85.4, 2) - 90, 0.05);
  EXPECT_EQ(reading.nearest->name, "left tragus");
  EXPECT_NEAR(reading.off_place_mm, std::hypot(4.6, 2), 1e-9);
  EXPECT_EQ(skinInWords(reading), "4.6 mm inside the skin");
}

TEST(TipCheck, ATipFarFromTheHeadCannotBeJudged) {
  EXPECT_TRUE(checkOnBall().read(Point<Mri>(0, 129, 0)).isNear());
  EXPECT_FALSE(checkOnBall().read(Point<Mri>(0, 131, 0)).isNear());
}

TEST(TipCheck, WithoutNamedPlacesTheSkinIsStillRead) {
  const TipCheck check(testing::ballMesh(90, 240, 320), {});
  const auto reading = check.read(Point<Mri>(0, 0, 91));
  EXPECT_FALSE(reading.nearest);
  EXPECT_EQ(inWords(reading), "1.0 mm outside the skin");
}

TEST(TipCheck, ASkinWithoutTrianglesIsRefused) { EXPECT_THROW(TipCheck({}, {}), Error); }

}  // namespace
}  // namespace facenav::guidance
