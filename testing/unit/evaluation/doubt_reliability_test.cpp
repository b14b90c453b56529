#include "facenav/evaluation/doubt_reliability.h"

#include <gtest/gtest.h>

namespace facenav::evaluation {
namespace {

TEST(DoubtReliability, BinsPlacesByTheirDoubtAndStatesTheirErrors) {
  std::vector<DoubtedPlace> places;
  for (int n = 0; n < 6; ++n) places.push_back({0, 0.5});
  for (int n = 0; n < 3; ++n) places.push_back({4, n == 0 ? 1.0 : 3.0});
  places.push_back({30, 12});
  const auto row = reliabilityRow("head", "brain", "true surface", places);
  ASSERT_EQ(row.bins.size(), 6u);
  EXPECT_EQ(row.bins[0].places, 6u);
  EXPECT_NEAR(row.bins[0].share, 0.6, 1e-12);
  EXPECT_NEAR(row.bins[0].mean_error_mm, 0.5, 1e-12);
  EXPECT_EQ(row.bins[0].wrong, 0);
  EXPECT_EQ(row.bins[1].places, 0u);
  EXPECT_EQ(row.bins[3].places, 3u);
  EXPECT_NEAR(row.bins[3].mean_error_mm, 7.0 / 3, 1e-12);
  EXPECT_NEAR(row.bins[3].wrong, 2.0 / 3, 1e-12);
  EXPECT_EQ(row.bins[5].places, 1u);
  EXPECT_NEAR(row.stated_certain, 0.6, 1e-12);
  EXPECT_NEAR(row.really_certain, 0.7, 1e-12);
  const auto text = reliabilityMarkdown({row});
  EXPECT_NE(text.find("| head | brain | true surface | 3-5 | 30.0 | 2.33 |"), std::string::npos) << text;
  EXPECT_NE(text.find("60.0 % stated within 2 mm, 70.0 % are"), std::string::npos) << text;
}

TEST(DoubtReliability, OfNothingHasEmptyBins) {
  for (const auto& bin : reliabilityOf({})) EXPECT_EQ(bin.places, 0u);
}

}  // namespace
}  // namespace facenav::evaluation
