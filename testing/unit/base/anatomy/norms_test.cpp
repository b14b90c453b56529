// Norms are complete and contain the people that they were measured on.

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "facenav/anatomy/brain_norms.h"
#include "facenav/anatomy/face_norms.h"
#include "facenav/anatomy/head_norms.h"

namespace facenav::anatomy {
namespace {

std::vector<Norm> allNorms() {
  std::vector<Norm> all{kNormalBrain, kPossibleBrain, kLargestBrain,      kBrainPerHeadBall,
                        kTargetDepth, kScannedHead,   kScannedHeadMiddle, kScannedHeadShortest,
                        kWholeHead,   kScanOfBrain,   kGirthRadius,       kHeadCircumference,
                        kPupils,      kEyesInSpace,   kFaceLikeness,      kFaceEdge,
                        kFaceDetail,  kFaceStrength};
  for (const FaceNorm& norm : faceNorms())
    if (norm.adults) all.push_back(*norm.adults);
  return all;
}

TEST(Norms, SayUnitPopulationAndSource) {
  const std::set<std::string> units{"mm", "ml", "1"};
  for (const Norm& norm : allNorms()) {
    EXPECT_LT(norm.low, norm.high) << norm.what;
    EXPECT_TRUE(units.count(norm.unit)) << norm.what;
    EXPECT_GT(std::string(norm.what).size(), 8u);
    EXPECT_GT(std::string(norm.population).size(), 4u) << norm.what;
    EXPECT_GT(std::string(norm.source).size(), 7u) << norm.what;
  }
}

TEST(Norms, BothEndsBelongToTheRangeAndNoNumberIsOutside) {
  EXPECT_TRUE(kNormalBrain.contains(1100) && kNormalBrain.contains(1700));
  EXPECT_FALSE(kNormalBrain.contains(1099.9) || kNormalBrain.contains(1700.1));
  EXPECT_FALSE(kTargetDepth.contains(std::nan("")));
}

TEST(BrainNorms, AVolumeThatNoAdultHasIsFoundOnceAndSaysWhatIsNormal) {
  EXPECT_FALSE(brainVolumeFinding(1100));
  EXPECT_FALSE(brainVolumeFinding(1700));
  EXPECT_EQ(brainVolumeFinding(1099),
            "the brain measures 1099 ml, adults have 1100 to 1700 ml: check its outline");
  EXPECT_TRUE(brainVolumeFinding(2300));
}

TEST(BrainNorms, ANormalBrainIsPossible) {
  EXPECT_LT(kPossibleBrain.low, kNormalBrain.low);
  EXPECT_GT(kPossibleBrain.high, kNormalBrain.high);
  EXPECT_GT(kLargestBrain.high, kPossibleBrain.high);
}

TEST(BrainNorms, TheHandAreaLiesInTheTemplatesBrainOnItsLeft) {
  EXPECT_TRUE(kTemplateBrain_mm.contains(kLeftHandKnob_mm));
  EXPECT_LT(kLeftHandKnob_mm.x(), 0);
}

/// The norms contain means with two standard deviations of published populations.
TEST(FaceNorms, HoldThePopulationsTheyNameAsSources) {
  const auto range = [](const std::string& name) {
    for (const FaceNorm& norm : faceNorms())
      if (norm.name == name) return *norm.adults;
    throw std::runtime_error("no such measure: " + name);
  };
  const auto expectInside = [](const Norm& norm, double mean, double sd) {
    EXPECT_TRUE(norm.contains(mean - 2 * sd) && norm.contains(mean + 2 * sd)) << norm.what << " " << mean;
  };
  expectInside(range("width of the head"), 154, 6);
  expectInside(range("width of the head"), 148, 5);
  expectInside(range("length of the head"), 200, 7);
  expectInside(range("length of the head"), 180, 7);
  expectInside(range("inner corners of the eyes"), 31.2, 1.5);
  expectInside(range("inner corners of the eyes"), 38.5, 3.2);
  expectInside(range("nose height, root to base"), 51.0, 1.9);
  expectInside(range("nose height, root to base"), 47.6, 3.1);
  expectInside(range("nose width over the wings"), 43.2, 3.8);
  expectInside(range("width of the face"), 134, 5);
  expectInside(kHeadCircumference, 576, 18);
  expectInside(kHeadCircumference, 559, 21);
}

TEST(FaceNorms, EyesInPicturesAreAllowedMoreThanPupils) {
  EXPECT_LT(kEyesInSpace.low, kPupils.low);
  EXPECT_GT(kEyesInSpace.high, kPupils.high);
}

TEST(HeadNorms, AHeadIsDeeperThanTheLongestOne) {
  for (const FaceNorm& norm : faceNorms())
    if (norm.adults) EXPECT_LT(norm.adults->high, kHeadDepth_mm) << norm.name;
}

}  // namespace
}  // namespace facenav::anatomy
