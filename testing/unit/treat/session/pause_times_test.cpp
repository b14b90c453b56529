#include "facenav/session/pause_times.h"

#include <gtest/gtest.h>

namespace facenav::session {
namespace {

TEST(PauseTimes, AddUpAndSayWhatLiesInThem) {
  PauseTimes pauses;
  EXPECT_FALSE(pauses.isPaused());
  EXPECT_TRUE(pauses.begin("warm", {10}));
  EXPECT_FALSE(pauses.begin("again", {11}));
  EXPECT_EQ(pauses.reason(), "warm");
  EXPECT_DOUBLE_EQ(pauses.end({14}).value(), 4);
  EXPECT_FALSE(pauses.end({15}));
  pauses.begin("", {20});
  EXPECT_DOUBLE_EQ(pauses.total_s({25}), 9);
  EXPECT_DOUBLE_EQ(pauses.total_s({12}), 2) << "up to a moment within";
  EXPECT_FALSE(pauses.holds({9.9}));
  EXPECT_TRUE(pauses.holds({10}));
  EXPECT_FALSE(pauses.holds({14}));
  EXPECT_TRUE(pauses.holds({1000})) << "not ended";
}

TEST(PauseTimes, APauseOfAnEarlierRunGoesOn) { EXPECT_TRUE(PauseTimes(true).isPaused()); }

}  // namespace
}  // namespace facenav::session
