#include "facenav/monitoring/drift_watchdog.h"

#include <gtest/gtest.h>

#include <future>

namespace facenav::monitoring {
namespace {

using Verdict = DriftFinding::Verdict;
using Mode = DriftWatchdog::Mode;

constexpr double kFrame_s = 1.0 / 60;
const RigidTransform<Camera, Mri> kPose;

std::shared_ptr<const cameras::StereoFrame> frame(std::int64_t number, double captured_s) {
  auto f = std::make_shared<cameras::StereoFrame>();
  f->number = number;
  f->captured = {captured_s};
  return f;
}

DriftFinding answer(Verdict verdict) {
  DriftFinding finding;
  finding.verdict = verdict;
  return finding;
}

/// Result of feeding `seconds` of frames: capture times at which the alarm began and ended.
struct Course {
  std::optional<double> began_s, ended_s;
  int measured = 0;
};
Course courseOf(
    double seconds, const std::function<Verdict(double)>& verdict_at,
    const std::function<bool(double)>& is_tracked = [](double) { return true; }) {
  Course course;
  DriftWatchdog watchdog(
      [&](const cameras::StereoFrame& frame, const auto&) {
        ++course.measured;
        return answer(verdict_at(frame.captured.s));
      },
      Mode::in_line);
  for (int i = 0; i * kFrame_s < seconds; ++i) {
    const double t_s = i * kFrame_s;
    watchdog.add(frame(i, t_s), is_tracked(t_s) ? std::optional(kPose) : std::nullopt);
    if (watchdog.isAlarmed() && !course.began_s) course.began_s = t_s;
    if (!watchdog.isAlarmed() && course.began_s && !course.ended_s) course.ended_s = t_s;
  }
  return course;
}

TEST(DriftWatchdog, ChecksOnceASecondAndIsQuietWhereAllAgrees) {
  const auto course = courseOf(10.0, [](double) { return Verdict::agrees; });
  EXPECT_FALSE(course.began_s);
  EXPECT_GE(course.measured, 9);
  EXPECT_LE(course.measured, 11);
}

TEST(DriftWatchdog, AlarmsWithin2SecondsOfADriftAndUntilTheNextGoodCheck) {
  for (double begin_s = 3.0; begin_s < 4.0; begin_s += 0.1) {
    const auto course = courseOf(
        12.0, [&](double t_s) { return t_s >= begin_s && t_s < 8.0 ? Verdict::drifted : Verdict::agrees; });
    ASSERT_TRUE(course.began_s && course.ended_s) << begin_s;
    EXPECT_GT(*course.began_s, begin_s);
    EXPECT_LT(*course.began_s, begin_s + 2.0);
    EXPECT_GT(*course.ended_s, 8.0);
    EXPECT_LT(*course.ended_s, 8.5);
  }
}

TEST(DriftWatchdog, OneOddAnswerIsNoAlarm) {
  int asked = 0;
  const auto once = courseOf(10.0, [&](double) { return ++asked == 5 ? Verdict::drifted : Verdict::agrees; });
  EXPECT_FALSE(once.began_s);
}

TEST(DriftWatchdog, KnowingNothingNeitherRaisesNorEndsAnAlarm) {
  EXPECT_FALSE(courseOf(10.0, [](double) { return Verdict::unknown; }).began_s);
  const auto course =
      courseOf(10.0, [](double t_s) { return t_s < 4.0 ? Verdict::drifted : Verdict::unknown; });
  EXPECT_TRUE(course.began_s);
  EXPECT_FALSE(course.ended_s);
}

TEST(DriftWatchdog, ChecksAFaceFoundAgainAtOnce) {
  double first_after_s = 0.0;
  courseOf(
      6.0,
      [&](double t_s) {
        if (t_s > 3.0 && first_after_s == 0.0) first_after_s = t_s;
        return Verdict::agrees;
      },
      [](double t_s) { return t_s < 2.2 || t_s > 3.0; });
  EXPECT_GT(first_after_s, 3.0);
  EXPECT_LT(first_after_s, 3.05);
}

/// Live frames continue while the face is measured; the answer is used when it arrives.
TEST(DriftWatchdog, NeverHoldsAFrameUp) {
  std::promise<void> finish;
  auto may_finish = finish.get_future().share();
  DriftWatchdog watchdog(
      [may_finish](const auto&, const auto&) {
        may_finish.wait();
        return answer(Verdict::drifted);
      },
      Mode::own_thread);
  // Blocks for ever if it waits for the answer.
  for (int i = 0; i < 600; ++i) watchdog.add(frame(i, i * kFrame_s), kPose);
  EXPECT_FALSE(watchdog.isAlarmed());
  finish.set_value();
  for (int i = 600; i < 2400 && !watchdog.isAlarmed(); ++i) {
    watchdog.add(frame(i, i * kFrame_s), kPose);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_TRUE(watchdog.isAlarmed());
}

}  // namespace
}  // namespace facenav::monitoring
