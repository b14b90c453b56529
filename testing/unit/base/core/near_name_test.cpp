#include "facenav/core/near_name.h"

#include <gtest/gtest.h>

namespace facenav {
namespace {

const std::vector<std::string> kVerbs{"series", "prepare", "calibrate", "calibrate-coil", "rig",
                                      "align",  "plan",    "track",     "simulate"};

TEST(NearName, CountsInsertedRemovedReplacedAndSwappedLetters) {
  EXPECT_EQ(lettersApart("align", "align"), 0u);
  EXPECT_EQ(lettersApart("algin", "align"), 1u);
  EXPECT_EQ(lettersApart("allign", "align"), 1u);
  EXPECT_EQ(lettersApart("alig", "align"), 1u);
  EXPECT_EQ(lettersApart("aligm", "align"), 1u);
  EXPECT_EQ(lettersApart("", "rig"), 3u);
  EXPECT_EQ(lettersApart("kitten", "sitting"), 3u);
}

TEST(NearName, FindsTheMisspeltVerb) {
  EXPECT_EQ(nearName("prepar", kVerbs), "prepare");
  EXPECT_EQ(nearName("perpare", kVerbs), "prepare");
  EXPECT_EQ(nearName("trak", kVerbs), "track");
  EXPECT_EQ(nearName("rgi", kVerbs), "rig");
}

TEST(NearName, FindsAVerbByItsBeginning) {
  EXPECT_EQ(nearName("calib", kVerbs), "calibrate");
  EXPECT_EQ(nearName("sim", kVerbs), "simulate");
}

TEST(NearName, FindsNothingWhereNoNameIsNear) {
  EXPECT_EQ(nearName("frobnicate", kVerbs), std::nullopt);
  EXPECT_EQ(nearName("log", kVerbs), std::nullopt);
  EXPECT_EQ(nearName("", kVerbs), std::nullopt);
}

}  // namespace
}  // namespace facenav
