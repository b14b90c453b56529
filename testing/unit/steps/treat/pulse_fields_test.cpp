#include "facenav/treat/pulse_fields.h"

#include <gmock/gmock.h>

#include "facenav/casefile/pulse_file.h"
#include "facenav/casefile/session_log.h"
#include "facenav/casefile/session_pulses.h"
#include "facenav/efield/built_in_coils.h"
#include "facenav/plan/plan_edits.h"
#include "support/ball_with_cortex.h"
#include "support/test_data.h"
#include "unit/case/casefile/made_pulse.h"

namespace facenav::steps {
namespace {

using ::testing::HasSubstr;

class PulseFieldsTest : public ::testing::Test {
 protected:
  PulseFieldsTest()
      : store_(casefile::CaseStore::create(folder_.path() / "case", testing::ballWithCortex(), {}, false)),
        top_(targetOverCortex(plannedHead(store_), "top", Point<Mri>(0, 0, 68))) {}
  casefile::Pulse pulseAt(int number, double up_mm) const {
    auto pulse = casefile::madePulse(number);
    const RigidTransform<frames::Coil, frames::Coil> step(Eigen::Quaterniond::Identity(), {0, 0, -up_mm});
    pulse.camera_T_coil = *pulse.camera_T_mri * (coilPoseOf(top_) * step);
    pulse.target = top_;
    return pulse;
  }
  double known(const casefile::Pulse& pulse) const {
    const ReadHead head(store_);
    const CoilPose pose = *pulse.mri_T_coil();
    return head.near(pose)->at(efield::figureEight70(), pose, Eigen::Matrix3Xd(top_.cortex_point.mm)).norm();
  }
  /// A session's folder with three pulses, the last one lost.
  std::filesystem::path session() const {
    casefile::SessionLog log(store_.folder());
    casefile::PulseFile file(log.folder());
    file.keep(pulseAt(1, 0));
    file.keep(pulseAt(2, 5));
    file.keep(casefile::madeLostPulse(3));
    return log.folder();
  }

  testing::TemporaryFolder folder_;
  casefile::CaseStore store_;
  guidance::Target top_;
  TaskMonitor monitor_;
};

TEST_F(PulseFieldsTest, EachPulseGetsTheFieldOfItsOwnPoseAndALostOneNone) {
  const auto folder = session();
  EXPECT_EQ(computePulseFields(store_, folder, "figure8-70", monitor_), 2);
  const auto read = casefile::readSessionPulses(folder);
  ASSERT_EQ(read.pulses.size(), 3u);
  for (int i = 0; i < 2; ++i) {
    const auto& pulse = read.pulses[std::size_t(i)].pulse;
    ASSERT_TRUE(pulse.field);
    EXPECT_NEAR(*pulse.field->at_target, known(pulse), 1e-6);
    EXPECT_EQ(pulse.field->tier, 0) << "the case has no other model";
    EXPECT_EQ(pulse.field->coil, "figure8-70");
    EXPECT_FALSE(pulse.field->rate_A_per_us) << "the built-in coil has no largest rate";
    EXPECT_FALSE(pulse.e_target_v_per_m);
    EXPECT_GE(pulse.field->peak, *pulse.field->at_target * 0.97);
  }
  EXPECT_FALSE(read.pulses[2].pulse.field);
  const std::string csv = casefile::pulsesCsv(read.pulses);
  EXPECT_THAT(csv,
              HasSubstr(",in_pause,e_target_v_per_m_per_a_per_us,e_max_v_per_m,e_max_v_per_m_per_a_per_us,"
                        "e_max_x_mm,e_max_y_mm,e_max_z_mm,field_tier,field_coil\n"));
  EXPECT_THAT(csv, HasSubstr(",0,figure8-70\n"));
  EXPECT_THAT(csv, HasSubstr(",0,,,,,,,,\n")) << "the lost one";
}

TEST_F(PulseFieldsTest, TheRateFollowsFromTheOutputWhereTheCoilsFileHasItsLargest) {
  auto coil = efield::figureEight70();
  coil.largest_didt_A_per_us = 120;
  const PoseFields fields(std::make_shared<const ReadHead>(store_), coil);
  const auto pulse = pulseAt(1, 0);  // at 55 %
  const auto field = fieldOfPulse(fields, "folder/D70.ccd", pulse);
  ASSERT_TRUE(field);
  EXPECT_NEAR(*field->rate_A_per_us, 66, 1e-9);
  EXPECT_EQ(field->coil, "D70.ccd") << "no folder";
  const auto folder = session();
  casefile::keepPulseFields(folder, {{1, *field}});
  const auto read = casefile::readSessionPulses(folder);
  EXPECT_NEAR(*read.pulses[0].pulse.e_target_v_per_m, 66 * *field->at_target, 1e-6);
}

TEST_F(PulseFieldsTest, TheKeeperHasEveryPulseAtItsEndAndTheLastLineCounts) {
  const auto folder = session();
  {
    PulseFieldKeeper keeper(store_, folder, "figure8-70");
    for (int i = 1; i <= 3; ++i) keeper.add(i < 3 ? pulseAt(i, i) : casefile::madeLostPulse(i));
  }
  auto fields = casefile::readPulseFields(folder);
  ASSERT_EQ(fields.size(), 2u);
  EXPECT_NEAR(*fields.at(2).at_target, known(pulseAt(2, 2)), 1e-6);
  computePulseFields(store_, folder, "round", monitor_);
  EXPECT_EQ(casefile::readPulseFields(folder).at(2).coil, "round");
}

TEST_F(PulseFieldsTest, WithoutABrainTheSessionGoesOnAndTheFaultIsKnown) {
  const auto plain = casefile::CaseStore::create(folder_.path() / "plain", testing::ballCase(), {}, false);
  casefile::SessionLog log(plain.folder());
  PulseFieldKeeper keeper(plain, log.folder(), "figure8-70");
  keeper.add(pulseAt(1, 0));
  for (int i = 0; i < 400 && keeper.failure().empty(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_THAT(keeper.failure(), HasSubstr("no brain model"));
  EXPECT_TRUE(casefile::readPulseFields(log.folder()).empty());
}

}  // namespace
}  // namespace facenav::steps
