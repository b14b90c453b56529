#include "facenav/review/session_compare.h"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/case/casefile/made_pulse.h"

namespace facenav::steps {
namespace {

/// Pulses at the target of madePulse, the coil at `target_T_coil` and beside it by `spread_mm` to both sides.
std::vector<casefile::ReviewedPulse> session(const RigidTransform<frames::Target, Coil>& target_T_coil,
                                             double spread_mm) {
  std::vector<casefile::ReviewedPulse> pulses;
  for (int i = 1; i <= 4; ++i) {
    auto pulse = casefile::madePulse(i);
    const RigidTransform<frames::Target, frames::Target> aside(Eigen::Quaterniond::Identity(),
                                                               {i % 2 == 0 ? spread_mm : -spread_mm, 0, 0});
    pulse.camera_T_coil = *pulse.camera_T_mri * pulse.target->mri_T_target * aside * target_T_coil;
    pulse.mep_uv = 100.0 * i;
    pulses.push_back({pulse, false, {}});
  }
  return pulses;
}

TEST(SessionCompare, ReturnErrorIsThatOfTheMeanPoses) {
  const auto first = session({Eigen::Quaterniond::Identity(), {0, 0, 0}}, 0.5);
  // 3 mm along x, 4 mm along y, then turned by 10 degrees about the coil's own z.
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(10 * M_PI / 180, Eigen::Vector3d::UnitZ()));
  const auto second = session({turned, {3, 4, 0}}, 0.2);
  const auto comparison = compareSessions(first, second);
  ASSERT_EQ(comparison.targets.size(), 1u);
  const auto& back = comparison.targets[0];
  EXPECT_NEAR(back.distance_mm, 5.0, 1e-9);
  EXPECT_NEAR(back.tilt_deg, 0.0, 1e-5);
  EXPECT_NEAR(std::abs(back.twist_deg), 10.0, 1e-5);
  EXPECT_NEAR(back.angle_deg, 10.0, 1e-5);
  EXPECT_NEAR(back.first.spread_mm, 0.5, 1e-9);
  EXPECT_NEAR(back.second.spread_mm, 0.2, 1e-9);
  EXPECT_EQ(back.first.pulses, 4);
  EXPECT_NEAR(back.target_moved_mm, 0.0, 1e-12);
  EXPECT_EQ(back.mep_first_uv, 250.0);
}

TEST(SessionCompare, TheMeanRotationDoesNotDependOnTheQuaternionsSigns) {
  // Rotations of 170 and 190 degrees about z: their mean is 180, where w changes its sign.
  std::vector<casefile::ReviewedPulse> pulses;
  for (const double angle_deg : {170.0, 190.0}) {
    auto pulse = casefile::madePulse(int(pulses.size()) + 1);
    pulse.target->mri_T_target = {};
    const RigidTransform<Mri, Coil> mri_T_coil(
        Eigen::Quaterniond(Eigen::AngleAxisd(angle_deg * M_PI / 180, Eigen::Vector3d::UnitZ())), {0, 0, 0});
    pulse.camera_T_coil = *pulse.camera_T_mri * mri_T_coil;
    pulses.push_back({pulse, false, {}});
  }
  const auto mean = meanCoil(pulses, "M1, \"hand\"");
  ASSERT_TRUE(mean);
  EXPECT_NEAR((mean->mri_T_coil.rotation().col(0) + Eigen::Vector3d::UnitX()).norm(), 0, 1e-9);
  EXPECT_NEAR(mean->spread_deg, 10.0, 1e-6);
}

TEST(SessionCompare, ExcludedAndLostPulsesDoNotCountAndOtherTargetsAreNamed) {
  auto first = session({Eigen::Quaterniond::Identity(), {0, 0, 0}}, 0), second = first;
  auto far = casefile::madePulse(9, 50.0);
  second.push_back({far, true, "moved"});
  second.push_back({casefile::madeLostPulse(10), false, {}});
  far.target->name = "DLPFC";
  second.push_back({far, false, {}});
  const auto comparison = compareSessions(first, second);
  ASSERT_EQ(comparison.targets.size(), 1u);
  EXPECT_NEAR(comparison.targets[0].distance_mm, 0, 1e-9);
  EXPECT_TRUE(comparison.only_first.empty());
  EXPECT_EQ(comparison.only_second, std::vector<std::string>{"DLPFC"});
  EXPECT_TRUE(compareSessions({}, {}).targets.empty());
}

}  // namespace
}  // namespace facenav::steps
