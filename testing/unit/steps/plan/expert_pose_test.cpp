#include "facenav/plan/expert_pose.h"

#include <gmock/gmock.h>

#include "facenav/core/error.h"
#include "facenav/geometry/rotation.h"
#include "support/ball_case.h"
#include "support/made_session.h"
#include "support/test_data.h"

namespace facenav::steps {
namespace {

using ::testing::HasSubstr;

class ExpertPoseTest : public ::testing::Test {
 protected:
  ExpertPoseTest()
      : store_(casefile::CaseStore::create(folder_.path() / "case", testing::ballWithBrain(), {}, false)) {
    // The target is on the ball's crown, its axis to the middle.
    target_.name = "M1";
    target_.mri_T_target = {Eigen::Quaterniond(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX())),
                            {0, 0, 94}};
    target_.scalp_point = {0, 0, 90};
    target_.cortex_point = {0, 0, 40};
    store_.setTargets({{target_}});
  }
  std::string refusal(const ExpertRequest& request) const {
    try {
      storeExpertPose(store_, request);
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  }
  testing::TemporaryFolder folder_;
  casefile::CaseStore store_;
  guidance::Target target_;
};

TEST_F(ExpertPoseTest, IsTheMedianOfThePulsesOnTarget) {
  testing::MadeSession made;
  made.off_mm = {0.5, -0.5, 0};
  made.spread_mm = 0.4;
  made.pulses = 80;
  const auto session = testing::writeMadeSession(store_.folder(), target_, made);
  const auto target = storeExpertPose(store_, {});
  EXPECT_EQ(target.name, "expert M1");
  const Eigen::Vector3d off =
      (target_.mri_T_target.inverse() * Point<Mri>(target.mri_T_target.translation_mm())).mm;
  EXPECT_LT((off - made.off_mm).norm(), 0.15) << off.transpose();
  ASSERT_TRUE(target.expert);
  EXPECT_EQ(target.expert->session, session.filename().string());
  EXPECT_GT(target.expert->pulses, 50);
  EXPECT_NEAR(target.expert->spread_mm, 0.47, 0.15) << "median of a Rayleigh distribution: 1.18 sigma";
  EXPECT_LT(target.expert->spread_deg, 1e-3);
  EXPECT_EQ(target.expert->coil, "figure-8 70 mm");
  EXPECT_NEAR(target.cortex_point.mm.z(), 40, 1.5) << "where the axis meets the brain";
  EXPECT_NEAR((target.cortex_point.mm - target.mri_T_target.translation_mm()).head<2>().norm(), 0, 0.1);
  const auto read = store_.targets().find("expert M1");
  ASSERT_TRUE(read.expert);
  EXPECT_EQ(inWords(*read.expert), inWords(*target.expert));
  EXPECT_EQ(store_.targets().targets.size(), 2u) << "the plan stays";
}

TEST_F(ExpertPoseTest, SaysThatAPulseLayOutsideTheTolerance) {
  testing::MadeSession made;
  made.off_mm = {8, 0, 0};
  made.pulses = 3;
  testing::writeMadeSession(store_.folder(), target_, made);
  ExpertRequest request;
  request.pulse = 2;
  const auto caution = outsideCaution(store_, request);
  ASSERT_TRUE(caution);
  EXPECT_THAT(*caution, HasSubstr("pulse 2 lay outside the tolerance"));
  EXPECT_THAT(*caution, HasSubstr("from 'M1'"));
}

TEST_F(ExpertPoseTest, OfOnePulseIsThatPulse) {
  const auto session = testing::writeMadeSession(store_.folder(), target_);
  const auto pulse = casefile::readSession(session).pulses.pulses.at(2).pulse;
  ExpertRequest request;
  request.pulse = 3;
  request.name = "hotspot";
  const auto target = storeExpertPose(store_, request);
  EXPECT_LT((target.mri_T_target.translation_mm() - pulse.mri_T_coil()->translation_mm()).norm(), 1e-6);
  EXPECT_EQ(target.expert->pulses, 1);
  EXPECT_EQ(target.name, "hotspot");
  EXPECT_EQ(outsideCaution(store_, request).has_value(), pulse.status == casefile::PulseStatus::outside);
}

TEST_F(ExpertPoseTest, RefusesWhatIsNoPose) {
  EXPECT_THAT(refusal({}), HasSubstr("session"));
  testing::MadeSession far;
  far.off_mm = {30, 0, 0};
  const auto session = testing::writeMadeSession(store_.folder(), target_, far);
  EXPECT_THAT(refusal({}), HasSubstr("no pulse on target"));
  ExpertRequest one;
  one.pulse = 99;
  EXPECT_THAT(refusal(one), HasSubstr("no pulse 99"));
  one.pulse = 14;  // in the frames without a face
  EXPECT_THAT(refusal(one), HasSubstr("no pose"));
  casefile::editPulse(session, {2, true, "slipped", ""});
  one.pulse = 2;
  EXPECT_THAT(refusal(one), HasSubstr("slipped"));
}

TEST_F(ExpertPoseTest, ASessionWithoutATargetGivesItsPulsesOnlyWhereTheyAgree) {
  const auto write = [&](double spread_mm) {
    casefile::SessionLog log(store_.folder());
    log.addEvent("coil", "round");
    testing::MadeSession made;
    made.spread_mm = spread_mm;
    const testing::MadeFrames frames(made, target_);
    casefile::PulseFile file(log.folder());
    for (int i = 1; i <= 20; ++i) {
      auto pulse = testing::madePulseOf(i, 8 * i, frames, target_, false);
      pulse.target.reset(), pulse.offset.reset();
      pulse.status = casefile::PulseStatus::outside;
      pulse.coil = "round";
      file.keep(pulse);
    }
    return log.folder().filename().string();
  };
  ExpertRequest request;
  request.session = write(0.8);
  EXPECT_EQ(storeExpertPose(store_, request).name, "expert");
  EXPECT_EQ(storeExpertPose(store_, request).expert->coil, "round");
  request.session = write(9);
  EXPECT_THAT(refusal(request), HasSubstr("not one pose"));
}

TEST_F(ExpertPoseTest, ALockedTargetIsNotReplaced) {
  testing::writeMadeSession(store_.folder(), target_);
  auto locked = storeExpertPose(store_, {});
  locked.is_locked = true;
  store_.setTargets({{target_, locked}});
  EXPECT_THAT(refusal({}), HasSubstr("locked"));
}

}  // namespace
}  // namespace facenav::steps
