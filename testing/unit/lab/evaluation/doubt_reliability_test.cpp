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

TEST(DoubtReliability, PutsScansTogetherByTheContrastThatWasSeen) {
  std::vector<DoubtedPlace> sure(30, {0.5, 0.5}), unsure(10, {4, 1.5});
  std::vector<ReliabilityRow> rows{reliabilityRow("a", "brain", "true surface", sure),
                                   reliabilityRow("b", "brain", "true surface", unsure),
                                   reliabilityRow("b", "brain", "unperturbed mask", unsure)};
  rows[0].contrast = "T1", rows[1].contrast = rows[2].contrast = "T2";
  const auto pooled = pooledReliability(rows);
  ASSERT_EQ(pooled.size(), 3u) << "all, T1, T2";
  EXPECT_EQ(pooled[0].volume, "2 scans");
  EXPECT_NEAR(pooled[0].bins[0].share, 0.75, 1e-12);
  EXPECT_NEAR(pooled[0].bins[3].share, 0.25, 1e-12);
  EXPECT_NEAR(pooled[0].bins[0].really, 0.75, 1e-12);
  EXPECT_NEAR(pooled[0].bins[1].really, 0.25, 1e-12);
  EXPECT_NEAR(pooled[0].stated_certain, 0.75, 1e-12);
  EXPECT_NEAR(pooled[0].really_certain, 1, 1e-12);
  EXPECT_EQ(pooled[2].contrast, "T2");
  EXPECT_NEAR(pooled[2].bins[1].really, 1, 1e-12);
  const auto text = doubtBandsMarkdown(pooled);
  EXPECT_NE(text.find("| 2 scans | brain | all | 1-2 | 0.0 | 25.0 | 0.0 |"), std::string::npos) << text;
  rows.pop_back(), rows.pop_back();
  EXPECT_EQ(pooledReliability(rows).size(), 1u) << "one contrast is all of them";
}

TEST(DoubtReliability, OfNothingHasEmptyBins) {
  for (const auto& bin : reliabilityOf({})) EXPECT_EQ(bin.places, 0u);
}

}  // namespace
}  // namespace facenav::evaluation
