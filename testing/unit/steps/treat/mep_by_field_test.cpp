#include "facenav/treat/mep_by_field.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "facenav/core/error.h"
#include "facenav/efield/built_in_coils.h"
#include "facenav/plan/plan_edits.h"
#include "support/ball_with_cortex.h"
#include "support/test_data.h"
#include "unit/case/casefile/made_pulse.h"

namespace facenav::steps {
namespace {

/// Pulses with the coil held in many ways round a target; their MEPs follow the field at a known spot.
class MepByFieldTest : public ::testing::Test {
 protected:
  MepByFieldTest()
      : store_(casefile::CaseStore::create(folder_.path() / "case", testing::ballWithCortex(), {}, false)),
        top_(targetOverCortex(plannedHead(store_), "top", Point<Mri>(0, 0, 68))),
        fields_(std::make_shared<const ReadHead>(store_), efield::figureEight70()) {
    const Eigen::Vector3d wanted_mm(12, -9, 66);
    (fields_.places_mm().colwise() - wanted_mm).colwise().squaredNorm().minCoeff(&spot_);
  }
  CoilPose poseOf(int) {
    std::normal_distribution<double> aside_mm(0, 10);
    std::uniform_real_distribution<double> turn(-1.0, 1.0);
    const Eigen::Quaterniond turned(Eigen::AngleAxisd(turn(random_), Eigen::Vector3d::UnitZ()));
    const RigidTransform<frames::Coil, frames::Coil> step(
        turned, {aside_mm(random_), aside_mm(random_), -std::abs(0.2 * aside_mm(random_))});
    return coilPoseOf(top_) * step;
  }
  /// `makesMep`: from the field at the spot to uV.
  casefile::SessionPulses session(int pulses, const std::function<double(double)>& makesMep) {
    casefile::SessionPulses made;
    for (int i = 1; i <= pulses; ++i) {
      casefile::ReviewedPulse reviewed{casefile::madePulse(i), false, {}};
      const auto pose = poseOf(i);
      reviewed.pulse.camera_T_coil = *reviewed.pulse.camera_T_mri * pose;
      reviewed.pulse.mep_uv = makesMep(fields_.at(pose).strength[spot_]);
      made.pulses.push_back(std::move(reviewed));
    }
    return made;
  }
  double noise() { return std::normal_distribution<double>(0, 1)(random_); }
  Eigen::Vector3d spot_mm() const { return fields_.places_mm().col(spot_); }

  testing::TemporaryFolder folder_;
  casefile::CaseStore store_;
  guidance::Target top_;
  PoseFields fields_;
  Eigen::Index spot_ = 0;
  std::mt19937 random_{7};
};

TEST_F(MepByFieldTest, AKnownSpotIsFoundWithin5MmAndItsRegionHoldsIt) {
  // A sigmoid of the field with the scatter of real MEPs (factor 1.35), 80 pulses.
  const auto known = session(80, [this](double field) {
    return (20 + 1500 / (1 + std::exp(-6 * (field - 0.9)))) * std::exp(0.3 * noise());
  });
  const auto map = mepByField(fields_, known);
  EXPECT_EQ(map.pulses, 80);
  EXPECT_TRUE(map.regression.is_explained) << map.regression.chance;
  EXPECT_LT((map.spot.mm - spot_mm()).norm(), 5.0) << map.spot.mm.transpose();
  EXPECT_LT(map.region_mm, 20);
  EXPECT_LE((map.spot.mm - spot_mm()).norm(), map.region_mm + 3);
  EXPECT_GT(map.regression.r2, 0.5);
  EXPECT_GT(map.region_places, 0);
  EXPECT_EQ(map.curve.verdict, stimulation::CurveVerdict::sigmoid) << curveWords(map);
  EXPECT_THAT(inWords(map, "figure8-70").back(), ::testing::HasSubstr("a sigmoid describes"));
  const auto r2 = r2On(store_.brain()->mesh, fields_, map);
  EXPECT_EQ(r2.size(), store_.brain()->mesh.vertices_mm.size());
  float most = 0;
  for (const float value : r2) most = std::isnan(value) ? most : std::max(most, value);
  EXPECT_NEAR(most, map.regression.r2, 0.1);
}

TEST_F(MepByFieldTest, AStraightLineIsNamedWhereTheMepFollowsIt) {
  const auto map = mepByField(fields_, session(60, [](double field) { return 1000 * field; }));
  EXPECT_EQ(map.regression.response, stimulation::FieldResponse::linear);
  EXPECT_NEAR(map.regression.r2, 1, 1e-3);
  EXPECT_LT((map.spot.mm - spot_mm()).norm(), 2.0);
  EXPECT_NEAR(map.regression.chance, 1.0 / 401, 1e-9) << "no shuffled one reaches it";
  EXPECT_EQ(map.curve.verdict, stimulation::CurveVerdict::line);
  EXPECT_THAT(curveWords(map), ::testing::HasSubstr("no sigmoid: a straight line"));
}

TEST_F(MepByFieldTest, NoiseAloneExplainsNothing) {
  int explained = 0;
  for (int trial = 0; trial < 10; ++trial) {
    const auto map = mepByField(fields_, session(40, [this](double) { return 200 * std::exp(noise()); }));
    explained += map.regression.is_explained;
  }
  EXPECT_LE(explained, 2) << "of 10, by a chance of 5 %";
}

TEST_F(MepByFieldTest, PulsesWithoutPoseMepOrOutputAreLeftOutAndTooFewAreRefused) {
  auto made = session(24, [](double field) { return 1000 * field; });
  made.pulses[0].is_excluded = true;
  made.pulses[1].pulse.camera_T_mri.reset();
  made.pulses[2].pulse.mep_uv.reset();
  made.pulses[3].pulse.intensity_pct.reset();
  const auto map = mepByField(fields_, made);
  EXPECT_EQ(map.pulses, 20);
  EXPECT_EQ(map.left_out, 2);
  made.pulses[4].is_excluded = true;
  EXPECT_THROW(mepByField(fields_, made), Error);
  for (auto& reviewed : made.pulses) reviewed.is_excluded = false, reviewed.pulse.mep_uv = 100;
  EXPECT_THROW(mepByField(fields_, made), Error) << "all equal";
}

}  // namespace
}  // namespace facenav::steps
