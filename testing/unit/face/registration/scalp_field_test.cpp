#include "facenav/registration/scalp_field.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "support/model_head.h"

namespace facenav::registration {
namespace {

using facenav::testing::ModelHead;
using facenav::testing::towards;

/// A ball of radius 90 mm, vertices about 2 mm apart, cut off at z = -40 mm.
ModelHead ball() {
  ModelHead head;
  head.bumps.clear();
  head.radii_mm.setConstant(90);
  return head;
}

TEST(ScalpField, IsTheSignedDistanceToWhatTheMeshSamples) {
  const ScalpField field(ball().skin(-40));
  for (const double out_mm : {-2.5, -1.0, 0.0, 0.7, 2.5})
    for (const double up_deg : {-10.0, 17.0, 40.0, 61.0})
      for (const double right_deg : {-70.0, -20.0, 5.0, 66.0}) {
        const Eigen::Vector3d direction = towards(right_deg, up_deg);
        const FieldSample sample = field.fine(((90 + out_mm) * direction).cast<float>());
        // Facets of 2 mm lie up to 0.006 mm below a ball of 90 mm, interpolation adds as much.
        EXPECT_NEAR(sample.distance_mm, out_mm, 0.02) << direction.transpose();
        EXPECT_GT(sample.gradient.normalized().dot(direction.cast<float>()), 0.9995f);
        EXPECT_NEAR(sample.gradient.norm(), 1.0f, 0.02f);
        EXPECT_NEAR(field.coarse(((90 + out_mm) * direction).cast<float>()).distance_mm, out_mm, 0.1);
      }
  EXPECT_NEAR(field.fine(Eigen::Vector3f(0, 120, 0)).distance_mm, 30, 0.1);  // beyond the band
}

TEST(ScalpField, KnowsNoDistanceBeyondTheScansEnd) {
  const ScalpField field(ball().skin(-40));
  EXPECT_TRUE(std::isnan(field.fine(Eigen::Vector3f(0, 78, -48)).distance_mm));
  EXPECT_TRUE(std::isnan(field.coarse(Eigen::Vector3f(0, 78, -50)).distance_mm));
  EXPECT_EQ(field.fine(Eigen::Vector3f(0, 900, 0)).distance_mm, ScalpField::kFar_mm);
  EXPECT_EQ(field.fine(Eigen::Vector3f(0, std::nanf(""), 0)).distance_mm, ScalpField::kFar_mm);
}

class ScalpFieldFile : public ::testing::Test {
 protected:
  const std::filesystem::path path_ =
      std::filesystem::path(::testing::TempDir()) / ("scalp_field_" + std::to_string(::getpid()) + ".bin");
  ~ScalpFieldFile() override { std::filesystem::remove(path_); }
};

TEST_F(ScalpFieldFile, HoldsTheSameFieldAndIsBuiltAgainForAnotherSkinOrWhenDamaged) {
  const SkinModel skin = ball().skin(-40);
  const auto built = keptScalpField(skin, path_);
  const auto kept = ScalpField::read(skin, path_);
  ASSERT_TRUE(kept);
  for (const Eigen::Vector3f& p : {Eigen::Vector3f(30, 84, 5), {-20, 10, 87}, {0, 120, 0}, {0, 78, -48}})
    for (const auto of : {&ScalpField::fine, &ScalpField::coarse}) {
      const FieldSample a = (built.get()->*of)(p), b = (kept.get()->*of)(p);
      EXPECT_EQ(std::isnan(a.distance_mm), std::isnan(b.distance_mm));
      if (!std::isnan(a.distance_mm)) EXPECT_EQ(a.distance_mm, b.distance_mm);
    }
  EXPECT_EQ(built->noseTip_mm(), kept->noseTip_mm());
  EXPECT_EQ(built->middle_mm(), kept->middle_mm());

  SkinModel other = skin;
  other.points.points_mm[7].x() += 1e-6;
  EXPECT_FALSE(ScalpField::read(other, path_));
  std::string content = readWholeFile(path_);
  content[content.size() / 2] ^= 1;
  writeWholeFile(path_, content);
  EXPECT_FALSE(ScalpField::read(skin, path_));
  writeWholeFile(path_, content.substr(0, content.size() / 3));
  EXPECT_FALSE(ScalpField::read(skin, path_));
  EXPECT_TRUE(keptScalpField(skin, path_));
  EXPECT_TRUE(ScalpField::read(skin, path_)) << "kept anew";
  EXPECT_FALSE(ScalpField::read(skin, path_.string() + ".missing"));
  EXPECT_TRUE(keptScalpField(skin, "/proc/no/such/folder/field.bin")) << "a folder that cannot be written to";
}

TEST(ScalpField, FindsTheNose) {
  const ModelHead head;
  const Eigen::Vector3d nose = head.at(towards(0, -14));
  EXPECT_LT((ScalpField(head.skin()).noseTip_mm() - nose).norm(), 8.0);
}

TEST(ScalpField, RefusesASkinWithoutSurface) { EXPECT_THROW(ScalpField{SkinModel()}, Error); }

}  // namespace
}  // namespace facenav::registration
