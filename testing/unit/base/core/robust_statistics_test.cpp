#include "facenav/core/robust_statistics.h"

#include <gtest/gtest.h>

#include <random>

namespace facenav {
namespace {

TEST(Median, OfAnOddCountIsTheMiddleValue) {
  EXPECT_EQ(median(std::vector<double>{5, 1, 3}), 3);
  EXPECT_EQ(upperMedian(std::vector<double>{5, 1, 3}), 3);
  EXPECT_EQ(upperMedian(std::vector<int>{7}), 7);
}

TEST(Median, OfAnEvenCountIsTheMeanOfBothOrTheUpperByName) {
  const std::vector<double> values{4, 10, 1, 2};
  EXPECT_EQ(median(values), 3);
  EXPECT_EQ(upperMedian(values), 4);
  EXPECT_EQ(median(std::vector<float>{2, 1}), 1.5f);
}

TEST(Median, OfNothingIsZero) {
  EXPECT_EQ(median(std::vector<double>{}), 0);
  EXPECT_EQ(upperMedian(std::vector<float>{}), 0);
  EXPECT_EQ(medianAbsoluteDeviation(std::vector<double>{}, 3.0), 0);
  EXPECT_EQ(valueAtRank(std::vector<int>{}, 2), 0);
}

TEST(Rank, CountsFromZeroInAscendingOrder) {
  std::vector<int> values{30, 10, 20};
  EXPECT_EQ(valueAtRank(values, 0), 10);
  EXPECT_EQ(valueAtRank(values, 9), 30) << "beyond the end: the last";
  EXPECT_EQ(values.front(), 30) << "the list stays as it was";
  EXPECT_EQ(selectRank(values, 1), 20);
}

TEST(MedianAbsoluteDeviation, IsMeasuredFromTheGivenMiddle) {
  const std::vector<double> values{1, 2, 3, 4, 100};
  EXPECT_EQ(medianAbsoluteDeviation(values, 3.0), 1);
  EXPECT_EQ(medianAbsoluteDeviation(values, 0.0), 3);
}

TEST(MedianAbsoluteDeviation, GivesTheSigmaOfNormalErrorsAmongOutliers) {
  std::mt19937 random(1);
  std::normal_distribution<double> error(2.0, 0.5);
  std::vector<double> values;
  for (int i = 0; i < 20000; ++i) values.push_back(i % 20 == 0 ? 1e6 : error(random));
  const double middle = median(values);
  EXPECT_NEAR(middle, 2.0, 0.05);
  EXPECT_NEAR(kSigmaPerMad * medianAbsoluteDeviation(values, middle), 0.5, 0.05);
}

}  // namespace
}  // namespace facenav
