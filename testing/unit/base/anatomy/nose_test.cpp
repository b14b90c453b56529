// The nose is searched on a head in closed form: an ellipsoid of 75 x 95 x 115 mm with a nose whose tip is
// known.

#include "facenav/anatomy/nose.h"

#include <gtest/gtest.h>

#include <cmath>

#include "facenav/anatomy/face_regions.h"

namespace facenav::anatomy {
namespace {

constexpr double kTipForward_mm = 22.0, kTip_z_mm = -25.0;  // before the ellipsoid; Mri

/// A ridge from the root, 40 mm above the tip, that ends 12 mm below it.
double nose_mm(double x_mm, double z_mm) {
  const double down = (kTip_z_mm + 40.0 - z_mm) / 40.0;
  const double along =
      z_mm >= kTip_z_mm ? std::max(0.0, down) : std::max(0.0, 1.0 - (kTip_z_mm - z_mm) / 12.0);
  return kTipForward_mm * along * std::exp(-0.5 * x_mm * x_mm / (8.0 * 8.0));
}

/// Front half of the skin in steps of 1 mm. `end_z_mm`: the scan ends there.
std::vector<Eigen::Vector3d> frontOfHead(double end_z_mm = -110) {
  std::vector<Eigen::Vector3d> skin;
  for (double z = 114; z >= end_z_mm; z -= 1)
    for (double x = -74; x <= 74; x += 1) {
      const double rest = 1 - x * x / (75.0 * 75.0) - z * z / (115.0 * 115.0);
      if (rest > 0) skin.push_back({x, 95 * std::sqrt(rest) + nose_mm(x, z), z});
    }
  return skin;
}

TEST(FrontRelief, KeepsTheForemostOfACellAndSaysWhereThereIsNone) {
  const FrontRelief relief({{0, 1, 0}, {0.5, 7, 0.5}, {9, -50, 9}},
                           {5.0, FrontRelief::FirstRow::bottom, 20.0});
  EXPECT_EQ(relief.rows(), 2);
  EXPECT_EQ(relief.columns(), 2);
  EXPECT_EQ(relief.at(0, 0), 7);
  EXPECT_EQ(relief.at(1, 1), FrontRelief::kNone) << "farther back than 20 mm";
  EXPECT_EQ(relief.at(-1, 0), FrontRelief::kNone);
  EXPECT_EQ(relief.middleOf(0, 0), Eigen::Vector3d(2.5, 7, 2.5));
}

TEST(FrontRelief, CountsRowsFromTheTopOrTheBottom) {
  const std::vector<Eigen::Vector3d> skin{{0, 1, 0}, {0, 2, 10}};
  const FrontRelief down(skin, {5.0, FrontRelief::FirstRow::top}),
      up(skin, {5.0, FrontRelief::FirstRow::bottom});
  EXPECT_EQ(down.at(0, 0), 2);
  EXPECT_EQ(up.at(0, 0), 1);
  EXPECT_EQ(down.z_mm(2), 0);
  EXPECT_EQ(up.z_mm(2), 10);
}

TEST(Nose, ItsTipIsFoundToACell) {
  const Eigen::Vector3d tip(0, 95 * std::sqrt(1 - 25.0 * 25 / (115.0 * 115)) + kTipForward_mm, kTip_z_mm);
  EXPECT_LT((findNoseTip(frontOfHead()) - tip).norm(), 4.0);
}

TEST(Nose, TheRimStandsForATipThatTheScanCuts) {
  const Eigen::Vector3d rim = findNoseTip(frontOfHead(-10));  // 15 mm above the tip
  EXPECT_NEAR(rim.x(), 0, 4.0);
  EXPECT_NEAR(rim.z(), -10, 6.0);
}

TEST(FaceRegions, AreNamedFromTheTipOutwards) {
  const FaceRegions regions(Eigen::Vector3d(2, 110, -30));
  const auto at = [&](double right, double up) {
    return regions.nameOf(Eigen::Vector3d(2 + right, 100, -30 + up));
  };
  EXPECT_EQ(at(0, 0), "nose");
  EXPECT_EQ(at(0, 70), "forehead");
  EXPECT_EQ(at(30, 30), "right brow");
  EXPECT_EQ(at(-40, 5), "left cheekbone");
  EXPECT_EQ(at(0, -30), "mouth");
  EXPECT_EQ(at(0, -60), "chin");
}

}  // namespace
}  // namespace facenav::anatomy
