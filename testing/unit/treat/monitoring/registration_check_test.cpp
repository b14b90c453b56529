#include "facenav/monitoring/registration_check.h"

#include <gmock/gmock.h>

namespace facenav::monitoring {
namespace {

using ::testing::HasSubstr;
using Verdict = DriftFinding::Verdict;

DriftFinding measured(Verdict verdict, double shift_mm = 0.3) {
  DriftFinding finding;
  finding.verdict = verdict;
  finding.shift_mm = shift_mm;
  finding.turn_deg = 0.1 * shift_mm;
  return finding;
}

std::shared_ptr<const cameras::StereoFrame> frameAt(double captured_s) {
  auto frame = std::make_shared<cameras::StereoFrame>();
  frame->captured = {captured_s};
  return frame;
}

/// Result of a check with these measurements in turn, and its time (s after its begin).
struct Checked {
  std::optional<RegistrationFinding> finding;
  double took_s = 0;
};
Checked check(const std::vector<DriftFinding>& answers, bool is_tracked = true) {
  std::size_t next = 0;
  RegistrationCheck registration(
      [&](const auto&, const auto&) { return answers[std::min(next++, answers.size() - 1)]; },
      DriftWatchdog::Mode::in_line);
  Checked checked;
  EXPECT_FALSE(registration.isRunning());
  registration.add(frameAt(0), RigidTransform<Camera, Mri>());
  EXPECT_EQ(next, 0u) << "nothing is measured before it is asked for";
  registration.begin();
  for (int i = 0; i <= 300 && !checked.finding; ++i) {
    checked.took_s = i / 60.0;
    registration.add(frameAt(5 + checked.took_s),
                     is_tracked ? std::optional(RigidTransform<Camera, Mri>()) : std::nullopt);
    checked.finding = registration.take();
  }
  EXPECT_FALSE(registration.isRunning());
  return checked;
}

TEST(RegistrationCheck, AFaceThatIsWhereItIsTrackedPassesWithinTwoSeconds) {
  const auto checked = check({measured(Verdict::agrees)});
  ASSERT_TRUE(checked.finding);
  EXPECT_TRUE(checked.finding->hasPassed());
  EXPECT_EQ(checked.finding->measurements, 5);
  EXPECT_EQ(checked.finding->number, 1);
  EXPECT_LE(checked.took_s, 2.05);
  EXPECT_THAT(inWords(*checked.finding), HasSubstr("passed: face 0.3 mm"));
}

TEST(RegistrationCheck, AFaceThatIsElsewhereFailsThoughOneMeasurementAgrees) {
  const auto checked = check({measured(Verdict::agrees), measured(Verdict::drifted, 3.0)});
  EXPECT_EQ(checked.finding->verdict, Verdict::drifted);
  EXPECT_DOUBLE_EQ(checked.finding->shift_mm, 3.0);
  EXPECT_THAT(inWords(*checked.finding), HasSubstr("failed: face 3.0 mm"));
}

TEST(RegistrationCheck, OneBadMeasurementOfFiveDoesNotFailIt) {
  const auto checked = check({measured(Verdict::drifted, 3.0), measured(Verdict::agrees)});
  EXPECT_TRUE(checked.finding->hasPassed());
}

TEST(RegistrationCheck, AHiddenFaceIsUnknownNotPassed) {
  for (const auto& checked :
       {check({measured(Verdict::unknown)}), check({measured(Verdict::agrees)}, false)}) {
    ASSERT_TRUE(checked.finding);
    EXPECT_EQ(checked.finding->verdict, Verdict::unknown);
    EXPECT_FALSE(checked.finding->hasPassed());
    EXPECT_THAT(inWords(*checked.finding), HasSubstr("not possible"));
  }
}

TEST(RegistrationCheck, AsManyForAsAgainstHasNotPassed) {
  EXPECT_EQ(findingOf({measured(Verdict::agrees), measured(Verdict::agrees), measured(Verdict::drifted),
                       measured(Verdict::drifted)})
                .verdict,
            Verdict::drifted);
  EXPECT_EQ(findingOf({measured(Verdict::agrees)}).verdict, Verdict::unknown) << "one is too few";
  EXPECT_EQ(findingOf({}).measurements, 0);
}

}  // namespace
}  // namespace facenav::monitoring
