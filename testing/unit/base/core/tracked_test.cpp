#include "facenav/core/tracked.h"

#include <gtest/gtest.h>

namespace facenav {
namespace {

TEST(Tracked, HoldsAValueWithItsQuality) {
  const Tracked<int> track(7, 0.8);
  ASSERT_TRUE(track);
  EXPECT_EQ(*track, 7);
  EXPECT_EQ(track.quality(), 0.8);
  EXPECT_THROW(track.reason(), std::logic_error);
}

TEST(Tracked, LostHasAReasonAndNoValue) {
  const Tracked<int> track = Lost{LostReason::no_face};
  EXPECT_FALSE(track);
  EXPECT_THROW(track.value(), std::logic_error);
  EXPECT_THROW(*track, std::logic_error);
  EXPECT_EQ(track.quality(), 0.0);
  EXPECT_EQ(track.reason(), LostReason::no_face);
}

TEST(Tracked, QualityOutsideItsRangeIsABug) { EXPECT_THROW(Tracked<int>(7, 1.5), std::logic_error); }

TEST(LostReason, WordsAreThoseOfPosesCsv) {
  for (const char* word : {"no_face", "few_features", "no_marker", "high_residual", "camera", "stale"})
    EXPECT_EQ(toString(lostReasonFromString(word)), word);
  EXPECT_THROW(lostReasonFromString("tired"), Error);
}

}  // namespace
}  // namespace facenav
