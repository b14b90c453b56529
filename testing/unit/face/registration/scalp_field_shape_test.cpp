// General properties of a distance field: its gradient is its derivative, bricks join, and the file of one
// skin is refused for another.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "facenav/core/whole_file.h"
#include "facenav/registration/scalp_field.h"
#include "model_field.h"

namespace facenav::registration {
namespace {

using testing::modelField;
using testing::modelHead;

/// Places within 2 mm of the model head's front.
std::vector<Eigen::Vector3f> nearTheFace(int count) {
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  std::vector<Eigen::Vector3f> places;
  while (int(places.size()) < count) {
    const Eigen::Vector3d direction =
        Eigen::Vector3d(normal(random), std::abs(normal(random)), normal(random)).normalized();
    if (modelHead().at(direction).z() < -60) continue;
    places.push_back((modelHead().at(direction) + 0.8 * normal(random) * direction).cast<float>());
  }
  return places;
}

TEST(ScalpField, TheGradientIsTheDistancesDerivative) {
  constexpr float h = 0.01f;
  for (const auto of : {&ScalpField::fine, &ScalpField::coarse}) {
    std::vector<float> off;
    for (const auto& p : nearTheFace(200)) {
      const FieldSample here = (modelField().*of)(p);
      Eigen::Vector3f derivative;
      for (int a = 0; a < 3; ++a) {
        const Eigen::Vector3f step = h * Eigen::Vector3f::Unit(a);
        derivative[a] =
            ((modelField().*of)(p + step).distance_mm - (modelField().*of)(p - step).distance_mm) / (2 * h);
      }
      off.push_back((here.gradient - derivative).norm());
    }
    // If the two places lie in different cells, the derivative is that of neither.
    std::sort(off.begin(), off.end());
    EXPECT_LT(off[off.size() * 9 / 10], 0.01f);
  }
}

TEST(ScalpField, IsContinuousOverCellsAndBricks) {
  // 100 mm along a straight line through the band: neighbours 0.05 mm apart differ by no more than that.
  const Eigen::Vector3f from = (modelHead().at(facenav::testing::towards(-30, 25))).cast<float>(),
                        to = (modelHead().at(facenav::testing::towards(30, 20))).cast<float>();
  const int steps = int((to - from).norm() / 0.05f);
  float last = modelField().fine(from).distance_mm;
  for (int i = 1; i <= steps; ++i) {
    const float here = modelField().fine(from + float(i) / float(steps) * (to - from)).distance_mm;
    // Beyond the band the coarse grid takes over, which is off by tenths of a millimetre there.
    EXPECT_LT(std::abs(here - last), std::abs(here) < ScalpField::kBand_mm ? 0.06f : 1.0f) << i;
    last = here;
  }
}

TEST(ScalpField, KnowsTheBoxOfItsSkin) {
  const ScalpField& field = modelField();
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e9), high = -low;
  for (const auto& v : field.skin().points.points_mm) low = low.cwiseMin(v), high = high.cwiseMax(v);
  EXPECT_EQ(field.low_mm(), low);
  EXPECT_EQ(field.high_mm(), high);
  EXPECT_EQ(field.middle_mm(), Eigen::Vector3d(0.5 * (low + high)));
}

TEST(ScalpField, TurnsWithItsSkin) {
  // The grids lie elsewhere on the head then; the distance must not change.
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.15, Eigen::Vector3d(0.3, 0.5, 0.8).normalized()).toRotationMatrix();
  SkinModel turned = modelHead().skin();
  for (auto& p : turned.points.points_mm) p = turn * p;
  for (auto& n : turned.points.normals) n = turn * n;
  for (auto& [point, normal] : turned.field_of_view) point.mm = turn * point.mm, normal.v = turn * normal.v;
  const ScalpField field(turned);
  std::vector<float> off_mm;
  for (const auto& p : nearTheFace(200))
    off_mm.push_back(
        std::abs(field.fine(turn.cast<float>() * p).distance_mm - modelField().fine(p).distance_mm));
  std::sort(off_mm.begin(), off_mm.end());
  EXPECT_LT(off_mm[off_mm.size() / 2], 0.02f);
  EXPECT_LT(off_mm.back(), 0.25f) << "in a crease, at most";
}

class KeptField : public ::testing::Test {
 protected:
  const std::filesystem::path path_ =
      std::filesystem::path(::testing::TempDir()) / ("kept_field_" + std::to_string(::getpid()) + ".bin");
  ~KeptField() override { std::filesystem::remove(path_); }

  /// Returns true if the changed file is refused.
  bool isRefusedWith(const std::string& content) {
    writeWholeFile(path_, content);
    return !ScalpField::read(modelField().skin(), path_);
  }
};

TEST_F(KeptField, AByteChangedAnywhereIsNoticed) {
  modelField().write(path_);
  const std::string content = readWholeFile(path_);
  for (const double where : {0.0, 0.1, 0.35, 0.6, 0.85, 1.0}) {
    std::string damaged = content;
    damaged[std::size_t(where * double(content.size() - 1))] ^= 4;
    EXPECT_TRUE(isRefusedWith(damaged)) << where;
  }
  for (const std::size_t size : {std::size_t(0), std::size_t(5), std::size_t(40), content.size() - 1})
    EXPECT_TRUE(isRefusedWith(content.substr(0, size))) << size;
  EXPECT_TRUE(isRefusedWith(content + "x"));
  EXPECT_FALSE(isRefusedWith(content));
}

TEST_F(KeptField, OnlyItsOwnerMayReadAHeadsShape) {
  modelField().write(path_);
  using std::filesystem::perms;
  EXPECT_EQ(std::filesystem::status(path_).permissions() & perms::mask,
            perms::owner_read | perms::owner_write);
}

TEST_F(KeptField, OfASkinWithAnotherFieldOfViewIsAnother) {
  modelField().write(path_);
  SkinModel skin = modelField().skin();
  skin.field_of_view[0].first.mm.z() += 1;
  EXPECT_FALSE(ScalpField::read(skin, path_));
  skin = modelField().skin();
  std::swap(skin.triangles[0], skin.triangles[1]);
  EXPECT_FALSE(ScalpField::read(skin, path_));
  EXPECT_TRUE(ScalpField::read(modelField().skin(), path_));
}

}  // namespace
}  // namespace facenav::registration
