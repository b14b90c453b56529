// Bounds of counted rates, against published figures.

#include "facenav/evaluation/rate_bound.h"

#include <gtest/gtest.h>

namespace facenav::evaluation {
namespace {

TEST(RateBound, WithoutAnEventIsTheRuleOfThree) {
  EXPECT_NEAR(rateBound95(0, 500), 3.0 / 500, 5e-5);
  EXPECT_NEAR(rateBound95(0, 1), 0.95, 1e-9);  // (1 - p)^1 = 0.05
}

TEST(RateBound, IsClopperAndPearsons) {  // quantile 0.95 of Beta(events + 1, trials - events)
  EXPECT_NEAR(rateBound95(1, 20), 0.21611, 1e-5);
  EXPECT_NEAR(rateBound95(3, 19), 0.35943, 1e-5);
}

TEST(RateBound, IsAllWhereNothingElseWasSeen) {
  EXPECT_EQ(rateBound95(0, 0), 1.0);
  EXPECT_EQ(rateBound95(7, 7), 1.0);
}

}  // namespace
}  // namespace facenav::evaluation
