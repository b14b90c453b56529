#include "facenav/guidance/guidance_csv.h"

#include <gtest/gtest.h>

#include "facenav/core/whole_file.h"
#include "made_targets.h"
#include "support/test_data.h"

namespace facenav::guidance {
namespace {
using namespace guidance::testing;

TEST(GuidanceCsv, HasTheColumnsOfTheFormatAndDegrees) {
  const facenav::testing::TemporaryFolder folder;
  const Target target = vertexTarget();
  const RigidTransform<Camera, Mri> camera_T_mri;
  const auto coil = coilAt(target, {3, 4, -12}, about(Eigen::Vector3d::UnitZ(), -6));
  GuidanceRow adjust{
      0, 0.0, "M1 hand L", evaluate(target, {camera_T_mri, 1.0}, {camera_T_mri * coil, 1.0}, {}, 0.35), {}};
  adjust.gap.by_poses_mm = 4.25;
  adjust.gap.live = LiveSurface{0.5, 0.3};
  GuidanceRow lost{1,
                   0.016667,
                   "a, \"b\"",
                   evaluate(target, Lost{LostReason::no_face}, {camera_T_mri * coil, 1.0}, {}, 0.35),
                   {}};
  writeGuidanceCsv({adjust, lost}, folder.path() / "guidance.csv");
  EXPECT_EQ(readWholeFile(folder.path() / "guidance.csv"),
            "frame,t_s,target,state,distance_mm,lateral_mm,depth_mm,tilt_deg,twist_deg,beam_miss_mm,"
            "predicted_error_mm,gap_mm,gap_stereo_mm\n"
            "0,0.000000,M1 hand L,adjust,13.0000,5.0000,-12.0000,0.0000,-6.0000,5.0000,0.3500,4.25,3.75\n"
            "1,0.016667,\"a, \"\"b\"\"\",lost,,,,,,,,,\n");
}

}  // namespace
}  // namespace facenav::guidance
