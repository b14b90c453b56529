#include "facenav/capture/picture_matcher.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "facenav/capture/clock_map.h"

namespace facenav::capture {
namespace {

constexpr double kInterval_s = 1.0 / 30;

CameraPicture pictureAt(double s, std::int64_t sequence) { return {cv::Mat(), {s}, sequence}; }

/// Runs both cameras for `count` pictures, which arrive in the order of their times.
struct TwoCameras {
  double right_late_s = 0, jitter_s = 0, drift = 0;  // drift: of the right clock
  std::vector<int> left_dropped = {}, right_dropped = {};
  int count = 300;

  std::vector<PicturePair> pairs(PictureMatcher& matcher) const {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> jitter(-jitter_s, jitter_s);
    std::vector<std::tuple<double, bool, int>> events;
    const auto isIn = [](const std::vector<int>& list, int i) {
      return std::count(list.begin(), list.end(), i) > 0;
    };
    for (int i = 0; i < count; ++i) {
      if (!isIn(left_dropped, i)) events.emplace_back(i * kInterval_s + jitter(random), true, i);
      if (!isIn(right_dropped, i))
        events.emplace_back(i * kInterval_s * (1 + drift) + right_late_s + jitter(random), false, i);
    }
    std::sort(events.begin(), events.end());
    std::vector<PicturePair> all;
    for (const auto& [s, is_left, i] : events) {
      is_left ? matcher.addLeft(pictureAt(s, i)) : matcher.addRight(pictureAt(s, i));
      while (auto pair = matcher.take()) all.push_back(*pair);
    }
    return all;
  }
};

TEST(PictureMatcher, PairsByTheNearestTimeAndStatesTheDelay) {
  PictureMatcher matcher(kInterval_s);
  const auto pairs = TwoCameras{0.009, 0.001}.pairs(matcher);
  EXPECT_EQ(pairs.size(), 300u);
  for (const auto& pair : pairs) EXPECT_EQ(pair.left.sequence, pair.right.sequence);
  EXPECT_NEAR(matcher.timing().right_late_s, 0.009, 0.0005);
  EXPECT_LT(matcher.timing().spread_s, 0.001);
}

TEST(PictureMatcher, ALateRightCameraIsPairedWithTheNextLeftPicture) {
  PictureMatcher matcher(kInterval_s);
  const auto pairs =
      TwoCameras{0.8 * kInterval_s}.pairs(matcher);  // nearer to the next left one: 0.2 of an interval early
  EXPECT_GE(pairs.size(), 298u);
  EXPECT_NEAR(matcher.timing().right_late_s, -0.2 * kInterval_s, 1e-6);
}

TEST(PictureMatcher, DroppedPicturesOnOneSideLeaveTheirPartnersAlone) {
  PictureMatcher matcher(kInterval_s);
  TwoCameras run{0.005, 0.001};
  run.left_dropped = {50, 51, 52, 120};
  run.right_dropped = {80, 200, 201};
  const auto pairs = run.pairs(matcher);
  EXPECT_EQ(pairs.size(), 293u);
  for (const auto& pair : pairs) ASSERT_EQ(pair.left.sequence, pair.right.sequence);
  EXPECT_EQ(matcher.timing().left_alone, 3);
  EXPECT_EQ(matcher.timing().right_alone, 4);
}

TEST(PictureMatcher, HalfAnIntervalLateThePartnerDoesNotAlternate) {
  PictureMatcher matcher(kInterval_s);
  const auto pairs = TwoCameras{0.5 * kInterval_s, 0.003}.pairs(matcher);
  EXPECT_GE(pairs.size(), 298u);
  int changes = 0;
  for (std::size_t i = 1; i < pairs.size(); ++i)
    changes += std::signbit(pairs[i].right_late_s()) != std::signbit(pairs[i - 1].right_late_s());
  EXPECT_EQ(changes, 0);
}

TEST(PictureMatcher, ClocksThatDriftChangeThePartnerOnceAnInterval) {
  PictureMatcher matcher(kInterval_s);
  TwoCameras run;
  run.drift = 0.002;  // 3000 pictures: six intervals
  run.count = 3000;
  const auto pairs = run.pairs(matcher);
  EXPECT_GT(pairs.size(), 2980u);
  int changes = 0;
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    EXPECT_LE(std::abs(pairs[i].right_late_s()), 0.63 * kInterval_s);  // 0.6, followed with a lag
    changes += std::abs(pairs[i].right_late_s() - pairs[i - 1].right_late_s()) > 0.5 * kInterval_s;
  }
  EXPECT_EQ(changes, 6);
}

TEST(PictureMatcher, OneCameraAtHalfTheRateGivesPairsAtThatRate) {
  PictureMatcher matcher(kInterval_s);
  TwoCameras run{0.004};
  for (int i = 1; i < run.count; i += 2) run.right_dropped.push_back(i);
  const auto pairs = run.pairs(matcher);
  EXPECT_EQ(pairs.size(), 150u);
  for (const auto& pair : pairs) ASSERT_EQ(pair.left.sequence, pair.right.sequence);
}

TEST(PictureMatcher, ASilentSideHoldsNoMemory) {
  PictureMatcher matcher(kInterval_s);
  for (int i = 0; i < 100; ++i) matcher.addLeft(pictureAt(i * kInterval_s, i));
  EXPECT_FALSE(matcher.take());
  EXPECT_EQ(matcher.timing().left_alone, 92);
}

TEST(ClockMap, FitsADriftingClockBetterThanArrivalsDo) {
  ClockMap clock;
  std::mt19937 random(3);
  std::exponential_distribution<double> delay(1 / 0.004);  // transport: 3 ms and a tail
  double worst_s = 0, worst_arrival_s = 0;
  for (int i = 0; i < 600; ++i) {
    const double true_s = 1000 + i * kInterval_s, device_s = 5 + (true_s - 1000) * (1 + 50e-6);
    const double arrival_s = true_s + 0.003 + delay(random);
    const double error_s = clock.map(device_s, arrival_s) - true_s - 0.003;
    if (i < 60) continue;
    worst_s = std::max(worst_s, std::abs(error_s));
    worst_arrival_s = std::max(worst_arrival_s, arrival_s - true_s - 0.003);
  }
  EXPECT_LT(worst_s, 0.0008);
  EXPECT_GT(worst_arrival_s, 0.012);
  EXPECT_EQ(clock.steps(), 0);
}

TEST(ClockMap, FollowsAClockThatJumpsAheadOrBack) {
  ClockMap clock;
  double jump_s = 0, last_s = 0;
  for (int i = 0; i < 300; ++i) {
    if (i == 100) jump_s = 3600;
    if (i == 200) jump_s = -50;
    const double true_s = 10 + i * kInterval_s, mapped_s = clock.map(77 + true_s + jump_s, true_s + 0.002);
    EXPECT_NEAR(mapped_s, true_s + 0.002, 1e-5) << i;
    EXPECT_GT(mapped_s, last_s);
    last_s = mapped_s;
  }
  EXPECT_EQ(clock.steps(), 2);
}

TEST(ClockMap, AStalledComputerIsNoJump) {
  ClockMap clock;
  for (int i = 0; i < 100; ++i) {
    const double true_s = i * kInterval_s, stall_s = i == 50 ? 0.4 : 0.0;
    EXPECT_NEAR(clock.map(true_s, true_s + 0.002 + stall_s), true_s + 0.002, 1e-6);
  }
  EXPECT_EQ(clock.steps(), 0);
}

/// 30 pictures a second are sent, and `read_hz` are read: the delay grows without limit.
TEST(ClockMap, AReaderThatLagsMoreAndMoreGetsTrueAges) {
  ClockMap clock;
  double arrival_s = 0, first_late_s = 0;
  for (int i = 0; i < 1400; ++i) {
    const double true_s = i * kInterval_s;
    arrival_s = std::max(true_s + 0.05, arrival_s + 1.0 / 26);
    ASSERT_NEAR(clock.map(5 + true_s, arrival_s), true_s + 0.05, 0.035) << "true age " << arrival_s - true_s;
    if (first_late_s == 0 && clock.lateFor_s() > 0) first_late_s = arrival_s;
  }
  EXPECT_GT(arrival_s - 1399 * kInterval_s, 6.0) << "seconds late";
  EXPECT_NEAR(first_late_s, 3.8, 0.5);
  EXPECT_NEAR(clock.lateFor_s(), arrival_s - first_late_s, 0.1);
  for (int i = 1400; i < 2500; ++i) {  // it catches up
    const double true_s = i * kInterval_s;
    arrival_s = std::max(true_s + 0.05, arrival_s + 1.0 / 60);
    ASSERT_NEAR(clock.map(5 + true_s, arrival_s), true_s + 0.05, 0.035) << "true age " << arrival_s - true_s;
  }
  EXPECT_EQ(clock.lateFor_s(), 0.0);
  EXPECT_EQ(clock.steps(), 0);
}

TEST(ClockMap, ABacklogAfterALongStallIsNoJump) {
  ClockMap clock;
  for (int i = 0; i < 400; ++i) {
    const double true_s = i * kInterval_s, late_s = i < 100 ? 0.0 : 3.0;  // the delay is never recovered
    ASSERT_NEAR(clock.map(7 + true_s, true_s + 0.002 + late_s), true_s + 0.002, 0.025) << i;
  }
  EXPECT_EQ(clock.steps(), 0);
  EXPECT_GT(clock.lateFor_s(), 9.0);
}

TEST(ClockMap, ADriftOf100PpmStaysFollowedForAnHour) {
  for (const double drift : {100e-6, -100e-6}) {
    ClockMap clock;
    for (int i = 0; i < 36000; ++i) {
      const double true_s = 0.1 * i;
      ASSERT_NEAR(clock.map(true_s * (1 + drift), true_s + 0.003), true_s + 0.003, 0.001)
          << drift << " " << i;
    }
    EXPECT_EQ(clock.steps(), 0);
    EXPECT_EQ(clock.lateFor_s(), 0.0);
  }
}

TEST(ClockMap, FollowsAJumpBackByLessThanAnInterval) {
  ClockMap clock;
  for (int i = 0; i < 200; ++i) {
    const double true_s = 0.1 * i, jump_s = i < 100 ? 0.0 : -0.06;
    const double mapped_s = clock.map(7 + true_s + jump_s, true_s + 0.002);
    const bool is_settled = i < 100 || i > 125;
    EXPECT_NEAR(mapped_s, true_s + 0.002, is_settled ? 0.001 : 0.061) << i;
  }
  EXPECT_EQ(clock.steps(), 1);
}

}  // namespace
}  // namespace facenav::capture
