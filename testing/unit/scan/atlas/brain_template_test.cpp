#include "facenav/atlas/brain_template.h"

#include <gmock/gmock.h>

#include <cmath>

#include "facenav/atlas/lobes.h"
#include "facenav/core/error.h"
#include "support/test_data.h"

namespace facenav::atlas {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;

class Colin27 : public ::testing::Test {
 protected:
  void SetUp() override { FACENAV_NEEDS(testing::colin27()); }
};

TEST_F(Colin27, NamesKnownPlacesAndKeepsLeftLeft) {
  const auto colin = readColin27();
  EXPECT_THAT(labelAt(colin.aal, {-37, -21, 58}).name, AnyOf("Precentral_L", "Postcentral_L"));  // hand area
  EXPECT_THAT(labelAt(colin.aal, {37, -21, 58}).name, AnyOf("Precentral_R", "Postcentral_R"));
  EXPECT_EQ(labelAt(colin.aal, {-24, -4, -18}).name, "Amygdala_L");
  EXPECT_EQ(labelAt(colin.aal, {14, 10, 10}).name, "Caudate_R");
  EXPECT_EQ(labelAt(colin.brodmann, {-8, -92, 2}).name, "BA 17");  // primary visual cortex
}

TEST_F(Colin27, AClickBesideTheCortexFindsTheNearestLabelAndFarAwayNone) {
  const auto colin = readColin27();
  EXPECT_EQ(labelAt(colin.aal, {-24, -4, -18}).distance_mm, 0.0);
  const auto outside = labelAt(colin.aal, {0, 200, 0});
  EXPECT_TRUE(outside.name.empty());
  EXPECT_TRUE(labelAt(colin.aal, {std::nan(""), 0, 0}).name.empty());
  EXPECT_TRUE(labelAt(colin.aal, {1e30, 0, 0}).name.empty());
  EXPECT_TRUE(labelAt(colin.aal, {500, 500, 500}).name.empty());
}

TEST_F(Colin27, LobesHaveNamesThatOneLooksUp) {
  const LobeMap lobes(readColin27().aal);
  EXPECT_EQ(lobes.at({-40, 16, -32}), "left temporal pole");
  EXPECT_EQ(lobes.at({40, 16, -32}), "right temporal pole");
  EXPECT_EQ(lobes.at({-30, -70, -40}), "left cerebellum");
  EXPECT_EQ(lobes.at({20, -98, 5}), "right occipital lobe");
  EXPECT_EQ(lobes.at({37, -21, 62}), "right motor strip");
  EXPECT_EQ(lobes.at({-20, 62, 32}), "left frontal lobe");  // slightly outside the cortex
  EXPECT_EQ(lobes.at({0, 200, 0}), "");
  EXPECT_EQ(lobes.at({900, 0, 0}), "");
}

TEST(BrainTemplate, AMissingAtlasNamesThePackage) {
  try {
    readColin27("/nowhere");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("mricron-data"));
  }
}

}  // namespace
}  // namespace facenav::atlas
