#include "facenav/volume/map_peak.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "facenav/core/error.h"
#include "support/matchers.h"
#include "support/refusal.h"

namespace facenav::volume {
namespace {
using facenav::testing::EigenNear;
using facenav::testing::refusalOf;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// A map of 3 mm voxels with Gaussian hills (place, height).
Volume hills(const std::vector<std::pair<Eigen::Vector3d, double>>& all) {
  Volume map;
  map.grid.size = {40, 40, 40};
  map.grid.mri_from_voxel.linear() *= 3.0;
  map.grid.mri_from_voxel.translation() = Eigen::Vector3d::Constant(-60);
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 40; ++i) {
        double value = 0;
        for (const auto& [place, height] : all)
          value +=
              height * std::exp(-(map.grid.toMri(Eigen::Vector3d(i, j, k)).mm - place).squaredNorm() / 128);
        map.voxels.push_back(float(value));
      }
  return map;
}

const Eigen::Vector3d kHill(-37.1, 20.4, 25.2), kHigher(30, -20, 10);

TEST(MapPeak, IsTheHillInTheRegionNotTheHighestOfTheMap) {
  const Volume map = hills({{kHill, 5}, {kHigher, 9}});
  const MapPeak peak = peakWithin(map, {-38, 22, 26}, 15, PeakOf::highest);
  EXPECT_THAT(peak.place_mm, EigenNear(kHill, 0.3)) << "a tenth of a voxel, by the parabola";
  EXPECT_NEAR(peak.value, 5, 0.2);
  EXPECT_FALSE(peak.is_at_edge);
}

TEST(MapPeak, OfAnticorrelationIsTheLowest) {
  const Volume map = hills({{kHill, -4}, {kHigher, 9}});
  EXPECT_THAT(peakWithin(map, {-38, 22, 26}, 15, PeakOf::lowest).place_mm, EigenNear(kHill, 0.3));
}

TEST(MapPeak, SaysWhenTheMapRisesOutOfTheRegion) {
  const Volume map = hills({{kHill, 5}});
  EXPECT_TRUE(peakWithin(map, kHill + Eigen::Vector3d(20, 0, 0), 8, PeakOf::highest).is_at_edge);
}

TEST(MapPeak, PassesOverValuesThatAreNotFinite) {
  Volume map = hills({{kHill, 5}});
  map.voxels[map.grid.index(8, 27, 28)] = std::numeric_limits<float>::quiet_NaN();
  map.voxels[map.grid.index(9, 27, 28)] = std::numeric_limits<float>::infinity();
  EXPECT_LT((peakWithin(map, kHill, 15, PeakOf::highest).place_mm - kHill).norm(), 5.0);
}

TEST(MapPeak, RefusesARegionWithoutValues) {
  const Volume map = hills({});
  EXPECT_THROW(peakWithin(map, {500, 0, 0}, 10, PeakOf::highest), Error);
  EXPECT_THROW(peakWithin(map, {0, 0, 0}, 10, PeakOf::highest), Error) << "all zero";
}

TEST(MapPeak, TheSpaceIsThatOfTheFileOrTheStatedOneAndNeverGuessed) {
  NiftiRead native, fitted;
  fitted.is_template_space = true;
  EXPECT_EQ(spaceOfMap(fitted, {}, "a.nii"), MapSpace::mni);
  EXPECT_EQ(spaceOfMap(fitted, MapSpace::mni, "a.nii"), MapSpace::mni);
  EXPECT_EQ(spaceOfMap(native, MapSpace::mri, "a.nii"), MapSpace::mri);
  EXPECT_EQ(spaceOfMap(native, MapSpace::mni, "a.nii"), MapSpace::mni)
      << "many programs write no template's code";
  EXPECT_THAT(refusalOf([&] { spaceOfMap(native, {}, "a.nii"); }),
              AllOf(HasSubstr("a.nii"), HasSubstr("--map-space mni, or --map-space mri")));
  EXPECT_THAT(refusalOf([&] { spaceOfMap(fitted, MapSpace::mri, "a.nii"); }),
              HasSubstr("a template's space"));
}

}  // namespace
}  // namespace facenav::volume
