#include "facenav/treat/hotspot.h"

#include <gmock/gmock.h>

#include <set>

#include "facenav/core/error.h"
#include "facenav/guidance/handle.h"
#include "support/ball_mesh.h"
#include "unit/case/casefile/made_pulse.h"

namespace facenav::steps {
namespace {

constexpr double kScalp_mm = 90, kCortex_mm = 75;

surface::ScalpSurface ballScalp() {
  surface::ScalpSurface scalp;
  scalp.mesh = testing::ballMesh(kScalp_mm, 120, 160);
  return scalp;
}

guidance::Target seed(const surface::ScalpSurface& scalp) {
  return guidance::planTarget("M1", scalp, Point<Mri>(-40, 10, 62), 0.8, 2.0);
}

/// A pulse with the coil at the target, and its MEP.
casefile::ReviewedPulse pulseAt(int number, const guidance::Target& target, double mep_uv) {
  casefile::ReviewedPulse reviewed;
  reviewed.pulse = casefile::madePulse(number);
  reviewed.pulse.camera_T_coil = *reviewed.pulse.camera_T_mri * target.mri_T_target.reframe<Mri, Coil>();
  reviewed.pulse.mep_uv = mep_uv;
  return reviewed;
}

TEST(Hotspot, TheGridLiesOnTheScalpRoundItsSeedAtLeastTheSpacingApart) {
  const auto scalp = ballScalp();
  const auto middle = seed(scalp);
  const auto sites = huntingSites(middle, scalp, {3, 5, 8.0});
  ASSERT_EQ(sites.size(), 15u);
  EXPECT_EQ(sites[0].name, "M1 2/3") << "the seed comes first";
  EXPECT_LT((sites[0].scalp_point.mm - middle.scalp_point.mm).norm(), 1e-6);
  for (std::size_t i = 1; i < sites.size(); ++i) {
    EXPECT_NEAR(sites[i].scalp_point.mm.norm(), kScalp_mm, 0.2) << sites[i].name;
    EXPECT_NEAR(guidance::hairGap_mm(sites[i]), 2.0, 0.2);
    EXPECT_GE((sites[i].scalp_point.mm - middle.scalp_point.mm).norm(), 7.5);
  }
  std::set<std::string> names;
  for (const auto& site : sites) names.insert(site.name);
  EXPECT_EQ(names.size(), 15u);
  EXPECT_THROW(huntingSites(middle, scalp, {16, 3, 8}), Error);
  EXPECT_THROW(huntingSites(middle, scalp, {3, 3, 0}), Error);
}

TEST(Hotspot, AKnownMapIsFoundAgainOnTheCortex) {
  const auto scalp = ballScalp();
  const auto cortex = testing::ballMesh(kCortex_mm, 120, 160);
  const auto sites = huntingSites(seed(scalp), scalp, {7, 7, 6.0});
  const Eigen::Vector3d hot_mm = kCortex_mm * sites[8].scalp_point.mm.normalized();
  casefile::SessionPulses session;
  for (const auto& site : sites) {
    const Eigen::Vector3d there_mm = kCortex_mm * site.scalp_point.mm.normalized();
    const double d_mm = (there_mm - hot_mm).norm();
    session.pulses.push_back(
        pulseAt(int(session.pulses.size()) + 1, site, 900 * std::exp(-0.5 * d_mm * d_mm / 49)));
  }
  auto lost = session.pulses[0];
  lost.pulse.number = 50, lost.pulse.camera_T_mri.reset();
  session.pulses.push_back(lost);
  const auto hotspot = hotspotOf(cortex, session, {});
  ASSERT_TRUE(hotspot);
  EXPECT_FALSE(hotspot->is_share);
  EXPECT_EQ(hotspot->pulses, 49);
  EXPECT_EQ(hotspot->without_place, 1);
  EXPECT_EQ(hotspot->peak_pulse, 9);
  EXPECT_LT((hotspot->map.peak.mm - hot_mm).norm(), 3.0) << "two vertices of the mesh";
  EXPECT_LT((hotspot->map.centre_of_gravity.mm - hot_mm).norm(), 3.0);
}

TEST(Hotspot, TwitchesGiveTheShareThatResponded) {
  const auto scalp = ballScalp();
  const auto sites = huntingSites(seed(scalp), scalp, {1, 3, 15.0});
  casefile::SessionPulses session;
  std::map<int, bool> twitches;
  for (int i = 0; i < 12; ++i) {
    session.pulses.push_back(pulseAt(i + 1, sites[std::size_t(i % 3)], 0));
    session.pulses.back().pulse.mep_uv.reset();
    twitches[i + 1] = i % 3 == 1;  // only at the second site
  }
  const auto hotspot = hotspotOf(testing::ballMesh(kCortex_mm, 120, 160), session, twitches);
  ASSERT_TRUE(hotspot);
  EXPECT_TRUE(hotspot->is_share);
  EXPECT_GT(hotspot->map.peak_uv, 0.9);
  EXPECT_LE(hotspot->map.peak_uv, 1.0);
  EXPECT_LT((hotspot->map.centre_of_gravity.mm - kCortex_mm * sites[1].scalp_point.mm.normalized()).norm(),
            1.0);
  EXPECT_FALSE(hotspotOf(testing::ballMesh(kCortex_mm), session, {})) << "nothing was answered";
}

}  // namespace
}  // namespace facenav::steps
