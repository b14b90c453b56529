#include "facenav/guidance/coil_gap.h"

#include <gtest/gtest.h>

namespace facenav::guidance {
namespace {

TEST(CoilGap, TheFieldLostAgreesWithTheComputedCoil) {
  // Figure-of-eight coil over a sphere, 20 mm deep (V/m at gaps of 0, 3, 5, 8 and 10 mm).
  const struct {
    double gap_mm, field;
  } computed[] = {{0, 80.66}, {3, 71.07}, {5, 65.43}, {8, 57.91}, {10, 53.46}};
  for (const auto& each : computed)
    EXPECT_NEAR(fieldLost_pct(each.gap_mm), 100 * (1 - each.field / computed[0].field), 0.6) << each.gap_mm;
  EXPECT_EQ(fieldLost_pct(-2), 0) << "a coil that is tracked inside the skin touches it";
}

TEST(CoilGap, TheCamerasGapIsThatToTheLiveSurface) {
  CoilGap gap;
  EXPECT_FALSE(gap.byStereo_mm());
  gap.by_poses_mm = 5.0;
  EXPECT_FALSE(gap.byStereo_mm());
  gap.live = LiveSurface{3.8, 0.6};
  EXPECT_DOUBLE_EQ(*gap.byStereo_mm(), 1.2);
}

TEST(CoilGap, ADisagreementBeyondItsOwnErrorIsSaid) {
  CoilGap gap;
  gap.by_poses_mm = 5.0;
  gap.live = LiveSurface{1.1, 0.6};
  EXPECT_FALSE(gap.disagrees()) << "1.1 mm are less than two standard errors of 0.6 mm";
  EXPECT_EQ(disagreementInWords(gap), "");
  gap.live->above_skin_mm = 1.3;
  EXPECT_TRUE(gap.disagrees());
  gap.alignment_sigma_mm = 0.8;
  EXPECT_DOUBLE_EQ(gap.apartSigma_mm(), 1.0);
  EXPECT_FALSE(gap.disagrees()) << "the alignment may be as wrong as that";
  gap.live->above_skin_mm = -2.5;
  EXPECT_EQ(
      disagreementInWords(gap),
      "beside the coil the cameras see the surface 2.5 mm inside the MRI's skin (error 1.0): the alignment "
      "is off, or something presses the skin");
}

}  // namespace
}  // namespace facenav::guidance
