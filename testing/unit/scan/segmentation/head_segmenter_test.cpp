#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "facenav/core/error.h"
#include "facenav/segmentation/segmenter.h"
#include "facenav/volume/nifti.h"
#include "head_phantom.h"
#include "support/skin_phantom.h"
#include "support/test_data.h"

namespace facenav::segmentation {
namespace {

using facenav::testing::SkinPhantom;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

volume::Mask headOf(const volume::Volume& volume) {
  TaskMonitor monitor;
  return makeHeadSegmenter()->segment(volume, monitor).mask;
}

volume::Mask truth(const SkinPhantom& phantom, const volume::VoxelGrid& grid) {
  volume::Mask mask{grid, std::vector<std::uint8_t>(grid.count())};
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i)
        mask.voxels[grid.index(i, j, k)] =
            phantom.toSkin(grid.toMri({double(i), double(j), double(k)}).mm) < 0;
  return mask;
}

TEST(HeadSegmenter, FindsTheSolidHeadAtAnyIntensityScaleAndOffset) {
  for (const auto& [scale, offset] : {std::pair(1.0, 0.0), std::pair(30.0, 500.0), std::pair(0.002, -0.4)}) {
    SkinPhantom phantom;
    phantom.scale = scale;
    phantom.offset = offset;
    phantom.noise = 4;
    const auto scan = phantom.scan({2, 2, 2});
    EXPECT_GT(volume::overlap(headOf(scan), truth(phantom, scan.grid)).dice, 0.97) << scale << " " << offset;
  }
}

TEST(HeadSegmenter, ClosesAnAirwayThatLeavesThroughTheScansEndAndDropsWrapAround) {
  SkinPhantom phantom;
  auto scan = phantom.scan({2, 2, 2}, {-100, -120, -80}, {100, 130, 135});
  for (int k = 0; k < scan.grid.size[2]; ++k)
    for (int j = 0; j < scan.grid.size[1]; ++j)
      for (int i = 0; i < scan.grid.size[0]; ++i) {
        const Eigen::Vector3d p = scan.grid.toMri({double(i), double(j), double(k)}).mm;
        if (std::hypot(p.x(), p.y() - 20) < 9 && p.z() < 0)
          scan.voxels[scan.grid.index(i, j, k)] = 1;  // airway
        if ((p - Eigen::Vector3d(0, -118, -30)).norm() < 12)
          scan.voxels[scan.grid.index(i, j, k)] = 60;  // nose, wrapped
      }
  const auto mask = headOf(scan);
  EXPECT_GT(volume::overlap(mask, truth(phantom, scan.grid)).dice, 0.97);
  const auto at = [&](double x, double y, double z) {
    const Eigen::Vector3d ijk = scan.grid.toVoxel(Point<Mri>(x, y, z));
    return mask.at(int(ijk[0] + 0.5), int(ijk[1] + 0.5), int(ijk[2] + 0.5));
  };
  EXPECT_TRUE(at(0, 20, -60));
  EXPECT_FALSE(at(0, -118, -30));
}

TEST(HeadSegmenter, DropsTheHeadHolderOfACt) {
  SkinPhantom phantom;
  phantom.dermis_mm = 0, phantom.fat_level = 1000, phantom.brain_level = 1040, phantom.offset = -1000,
  phantom.noise = 10;
  auto scan = phantom.scan({2, 2, 2});
  scan.modality = "CT";
  for (int k = 0; k < scan.grid.size[2]; ++k)
    for (int i = 0; i < scan.grid.size[0]; ++i)
      for (int j = 2; j < 4; ++j) scan.voxels[scan.grid.index(i, j, k)] = -100;  // a shell behind the head
  EXPECT_GT(volume::overlap(headOf(scan), truth(phantom, scan.grid)).dice, 0.97);
}

/// Changes the values by their position.
template <class Change>
void change(volume::Volume& scan, Change&& changed) {
  std::size_t v = 0;
  for (int k = 0; k < scan.grid.size[2]; ++k)
    for (int j = 0; j < scan.grid.size[1]; ++j)
      for (int i = 0; i < scan.grid.size[0]; ++i, ++v)
        scan.voxels[v] =
            float(changed(scan.voxels[v], scan.grid.toMri({double(i), double(j), double(k)}).mm));
}

TEST(HeadSegmenter, ShadingMovesTheOutlineByLessThanHalfAMillimetre) {
  SkinPhantom phantom;
  const auto even = phantom.scan({2, 2, 2});
  auto shaded = even;  // nearly three times as bright in front as behind
  change(shaded, [](float value, const Eigen::Vector3d& p) { return value * std::exp(0.005 * p.y()); });
  const auto a = headOf(even), b = headOf(shaded);
  EXPECT_NEAR(b.volume_ml(), a.volume_ml(), 45) << "0.5 mm of 900 cm2";
  EXPECT_GT(volume::overlap(a, b).dice, 0.99);
}

TEST(HeadSegmenter, HazeAroundTheHeadIsLeftOutAndSaid) {
  SkinPhantom phantom;
  phantom.dermis_mm = 0;
  auto scan = phantom.scan({2, 2, 2});
  const auto clear = headOf(scan);
  change(scan, [&](float value, const Eigen::Vector3d& p) {
    const double away = phantom.toSkin(p);
    return value + (away > 0 && away < 7 ? 0.2 * phantom.fat_level : 0.0);
  });
  TaskMonitor monitor;
  const auto hazy = makeHeadSegmenter()->segment(scan, monitor);
  EXPECT_NEAR(hazy.mask.volume_ml(), clear.volume_ml(), 90) << "1 mm of 900 cm2; the haze is 7 mm thick";
  EXPECT_THAT(hazy.warnings, ::testing::Contains(HasSubstr("haze")));
}

TEST(HeadSegmenter, SaysNothingOfPadsWhereThePriorSeesTheBrain) {
  const auto head = facenav::testing::makeHeadPhantom();
  TaskMonitor monitor;
  EXPECT_THAT(makeHeadSegmenter()->segment(head.volume, monitor).warnings,
              ::testing::Not(::testing::Contains(HasSubstr("pads and earphones"))));
}

TEST(HeadSegmenter, SaysThatThereIsNoHead) {
  volume::Volume empty;
  empty.grid.size = {100, 110, 120};
  empty.grid.mri_from_voxel.linear() *= 2;
  empty.voxels.assign(empty.grid.count(), 0.f);
  EXPECT_THAT([&] { headOf(empty); }, ThrowsMessage<Error>(HasSubstr("no head in this volume")));
  std::mt19937 random(3);
  std::normal_distribution<float> noise(0, 20);
  for (auto& voxel : empty.voxels) voxel = std::abs(noise(random));
  EXPECT_THAT([&] { headOf(empty); }, ThrowsMessage<Error>(HasSubstr("no head in this volume")));
  SkinPhantom bottle;
  bottle.head_mm = {30, 30, 40}, bottle.nose_mm = {1, 1, 1}, bottle.nose_at_mm = {0, 0, 0};
  EXPECT_THAT(
      [&] {
        headOf(bottle.scan({2, 2, 2}));
      },
      ThrowsMessage<Error>(HasSubstr("no head in this volume")));
}

TEST(HeadSegmenter, RealHeadsAreSolidAndOfAHeadsSize) {
  FACENAV_NEEDS(facenav::testing::colin27());
  const auto colin = volume::readNifti(facenav::testing::colin27()).volume;
  const auto mask = headOf(colin);
  EXPECT_NEAR(mask.volume_ml(), 4010, 60);  // within the scalp's mesh, which lies on the steepest edge
  const Eigen::Vector3d sinus = colin.grid.toVoxel(Point<Mri>(0, 10, -25));
  EXPECT_TRUE(mask.at(int(sinus[0]), int(sinus[1]), int(sinus[2])));
}

}  // namespace
}  // namespace facenav::segmentation
