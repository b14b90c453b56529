#include "facenav/anatomy/face_regions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

#include "facenav/anatomy/face_norms.h"

namespace facenav::anatomy {
namespace {

const Eigen::Vector3d kNose(3, 105, -20);
const FaceRegions kRegions(kNose);

Eigen::Vector3d at(double right, double up) { return kNose + Eigen::Vector3d(right, -20, up); }

TEST(FaceRegions, BothSidesAreNamedAlikeAndWeighAlike) {
  for (double up = -90; up <= 120; up += 3.5)
    for (double right = 1; right <= 90; right += 4.5) {
      std::string name = kRegions.nameOf(at(right, up)), other = kRegions.nameOf(at(-right, up));
      if (name.rfind("right ", 0) == 0) name.replace(0, 5, "left");
      EXPECT_EQ(name, other) << right << " " << up;
      EXPECT_NEAR(kRegions.softness(at(right, up)), kRegions.softness(at(-right, up)), 1e-12);
      EXPECT_NEAR(kRegions.foreignShare(at(right, up)), kRegions.foreignShare(at(-right, up)), 1e-12);
    }
}

TEST(FaceRegions, ThePatientsRightIsPositiveX) {
  EXPECT_EQ(kRegions.nameOf(at(40, -30)), "right cheek");
  EXPECT_EQ(kRegions.nameOf(at(-40, -30)), "left cheek");
  EXPECT_EQ(kRegions.nameOf(at(70, 30)), "right temple");
}

TEST(FaceRegions, WeightsAreSharesAndChangeWithoutAStep) {
  // Follows the three paths that cross all regions.
  for (double up = -90; up <= 130; up += 0.5)
    for (const double right : {0.0, 18.0, 45.0}) {
      const double soft = kRegions.softness(at(right, up)), hair = kRegions.foreignShare(at(right, up));
      EXPECT_GE(soft, 0);
      EXPECT_LE(soft, 1);
      EXPECT_GT(hair, 0);
      EXPECT_LT(hair, 1);
      EXPECT_LT(std::abs(kRegions.foreignShare(at(right, up + 0.5)) - hair), 0.02);
    }
}

TEST(FaceRegions, ForeheadIsFirmCheeksAndLipsAreSoft) {
  EXPECT_EQ(kRegions.softness(at(0, 60)), 0.0);
  EXPECT_EQ(kRegions.softness(at(25, 40)), 0.0);
  EXPECT_EQ(kRegions.softness(at(0, 5)), 0.0) << "the bridge of the nose";
  EXPECT_EQ(kRegions.softness(at(35, -25)), 1.0);
  EXPECT_EQ(kRegions.softness(at(0, -35)), 1.0) << "lips";
}

TEST(FaceRegions, HairIsLikelierAboveAndTowardsTheEars) {
  double last = 0;
  for (const double up : {0.0, 65.0, 80.0, 100.0}) {
    const double here = kRegions.foreignShare(at(0, up));
    EXPECT_GE(here, last);
    last = here;
  }
  EXPECT_GT(kRegions.foreignShare(at(0, 110)), 0.5);
  EXPECT_LT(kRegions.foreignShare(at(0, 40)), 0.1);
  EXPECT_GT(kRegions.foreignShare(at(70, 40)), kRegions.foreignShare(at(20, 40)) + 0.2);
}

TEST(FaceNorms, EndsBelongToThemAndNamesAreTheirsAlone) {
  std::set<std::string> names;
  for (const FaceNorm& norm : faceNorms()) {
    EXPECT_TRUE(names.insert(norm.name).second) << norm.name;
    EXPECT_STRNE(norm.from, norm.to);
    if (!norm.adults) continue;
    EXPECT_TRUE(norm.adults->contains(norm.adults->low) && norm.adults->contains(norm.adults->high));
    EXPECT_FALSE(norm.adults->contains(std::nextafter(norm.adults->low, 0.0))) << norm.name;
    EXPECT_FALSE(norm.adults->contains(std::nextafter(norm.adults->high, 1e9))) << norm.name;
  }
}

TEST(FaceNorms, FitTogether) {
  const auto of = [](const std::string& name) -> Norm {
    for (const FaceNorm& norm : faceNorms())
      if (norm.name == name) return *norm.adults;
    throw std::runtime_error("no such measure: " + name);
  };
  EXPECT_LT(of("inner corners of the eyes").high, of("centres of the closed lids").low);
  EXPECT_LT(of("nose height, root to base").high, of("nose root to chin").low);
  EXPECT_LT(of("width of the face").low, of("width of the head").low);
  EXPECT_LT(of("width of the head").high, of("length of the head").high);
  EXPECT_EQ(of("right tragus to nose tip").low, of("left tragus to nose tip").low);
  EXPECT_EQ(of("right tragus to nose root").high, of("left tragus to nose root").high);
}

}  // namespace
}  // namespace facenav::anatomy
