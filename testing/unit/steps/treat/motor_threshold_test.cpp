#include "facenav/treat/motor_threshold.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>

#include "facenav/casefile/pulse_file.h"
#include "facenav/core/error.h"
#include "support/test_data.h"
#include "unit/case/casefile/made_pulse.h"

namespace facenav::steps {
namespace {

namespace fs = std::filesystem;
using stimulation::ThresholdMethod;
using ::testing::HasSubstr;

TEST(MotorThreshold, ASearchGoesOnWhereItWasLeft) {
  const testing::TemporaryFolder folder;
  {
    MotorThreshold search({folder.path(), ThresholdMethod::bayes, "FDI right"});
    EXPECT_FALSE(search.isResumed());
    search.answer(52, true);
    search.answerWithMep(44, 49.9);
  }
  const MotorThreshold again({folder.path(), ThresholdMethod::bayes});
  EXPECT_TRUE(again.isResumed());
  ASSERT_EQ(again.kept().answers.size(), 2u);
  EXPECT_FALSE(again.kept().answers[1].answer.has_response) << "49.9 uV are no response";
  EXPECT_DOUBLE_EQ(again.kept().answers[1].mep_uv.value(), 49.9);
  EXPECT_THAT(again.inWords(), HasSubstr("1 response of 2 pulses, FDI right"));
  EXPECT_EQ(MotorThreshold({folder.path(), ThresholdMethod::five_of_ten}).kept().answers.size(), 0u)
      << "another method";
  EXPECT_EQ(casefile::readThresholds(folder.path()).size(), 2u);
  struct stat status {};
  ::stat(again.kept().path.c_str(), &status);
  EXPECT_EQ(status.st_mode & 0777, 0600u);
}

TEST(MotorThreshold, AnotherOneBeginsAfterItsEndOrWhenAskedFor) {
  const testing::TemporaryFolder folder;
  {
    MotorThreshold search({folder.path()});
    while (!search.state().isDone()) search.answer(*search.state().next_pct, *search.state().next_pct >= 60);
    EXPECT_NEAR(*search.state().estimate_pct, 59.5, 2);
  }
  EXPECT_FALSE(MotorThreshold({folder.path()}).isResumed());
  { MotorThreshold({folder.path()}).answer(50, true); }
  EXPECT_FALSE(MotorThreshold({folder.path(), ThresholdMethod::bayes, "", {}, true}).isResumed());
}

TEST(MotorThreshold, AWrongAnswerIsTakenBackAndTheFileKeepsBoth) {
  const testing::TemporaryFolder folder;
  MotorThreshold search({folder.path()});
  EXPECT_THROW(search.takeBack(), Error);
  search.answer(52, false);
  const double next_pct = *search.state().next_pct;
  search.answer(60, true);
  search.takeBack();
  EXPECT_DOUBLE_EQ(*search.state().next_pct, next_pct);
  EXPECT_THROW(search.answer(160, true), Error);
  EXPECT_THROW(search.answerWithMep(52, -3), Error);
  EXPECT_EQ(search.state().pulses, 1);
  EXPECT_EQ(casefile::readThreshold(search.kept().path).answers.size(), 1u);
}

TEST(MotorThreshold, ALineCutShortIsLeftOutAndTheNextOneIsWhole) {
  const testing::TemporaryFolder folder;
  fs::path path;
  {
    MotorThreshold search({folder.path()});
    search.answer(52, true);
    path = search.kept().path;
  }
  std::ofstream(path, std::ios::app) << R"({"utc": "2026-11-23T14:0)";
  {
    MotorThreshold search({folder.path()});
    EXPECT_EQ(search.kept().answers.size(), 1u);
    EXPECT_EQ(search.kept().problems.size(), 1u);
    search.answer(45, false);
  }
  EXPECT_EQ(casefile::readThreshold(path).answers.size(), 2u);
}

TEST(MotorThreshold, PulsesOfASessionAnswerInOrderWithoutTheExcludedOnes) {
  const testing::TemporaryFolder folder;
  casefile::PulseFile pulses(folder.path());
  for (int i = 1; i <= 5; ++i) {
    auto pulse = casefile::madePulse(i);
    pulse.intensity_pct = 50 + i;
    if (i == 5) pulse.intensity_pct.reset();
    if (i <= 2) pulse.mep_uv = i == 1 ? 80 : 20;
    pulses.keep(pulse);
  }
  casefile::editPulse(folder.path(), {2, true, "coil moved", ""});
  const auto answers =
      thresholdAnswers(casefile::readSessionPulses(folder.path()), {{1, false}, {3, true}, {5, true}});
  ASSERT_EQ(answers.size(), 2u) << "2 is excluded, 4 has no answer, 5 no intensity";
  EXPECT_TRUE(answers[0].has_response) << "its MEP says more than the twitch";
  EXPECT_DOUBLE_EQ(answers[1].intensity_pct, 53);
  EXPECT_TRUE(answers[1].has_response);
}

}  // namespace
}  // namespace facenav::steps
