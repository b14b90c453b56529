#include "facenav/surface/scalp_surface.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "facenav/core/error.h"
#include "facenav/volume/regrid.h"
#include "support/skin_phantom.h"
#include "support/test_data.h"

namespace facenav::surface {
namespace {

using facenav::testing::SkinPhantom;
using facenav::testing::TemporaryFolder;

const Eigen::Vector3d kFrontLow(-90, 0, -75),
    kFrontHigh(90, 118, 15);  // a slab with the nose: quick, and cut on four sides

/// True head mask, dilated by a voxel, as masks usually are.
volume::Mask maskOf(const SkinPhantom& phantom, const volume::VoxelGrid& grid) {
  volume::Mask mask{grid, std::vector<std::uint8_t>(grid.count())};
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i)
        mask.voxels[grid.index(i, j, k)] =
            phantom.toSkin(grid.toMri({double(i), double(j), double(k)}).mm) < 0.7;
  return mask;
}

struct Placement {
  double mean_mm, rms_mm, nose_mean_mm;
};
/// Distances to the true skin, away from the phantom's crease and 3 voxels from the scan's ends.
Placement placement(const SkinPhantom& phantom, const ScalpSurface& scalp, const volume::VoxelGrid& grid) {
  double sum = 0, squares = 0, nose = 0;
  int n = 0, n_nose = 0;
  for (const auto& v : scalp.mesh.vertices_mm) {
    const Eigen::Vector3d ijk = grid.toVoxel(Point<Mri>(v));
    bool is_inside = !phantom.isNearCrease(v);
    for (int a = 0; a < 3; ++a) is_inside = is_inside && ijk[a] > 3 && ijk[a] < grid.size[a] - 4;
    if (!is_inside) continue;
    const double d = phantom.toSkin(v);
    sum += d, squares += d * d, ++n;
    if (phantom.toNose(v) < 2) nose += d, ++n_nose;
  }
  return {sum / n, std::sqrt(squares / n), nose / std::max(1, n_nose)};
}

Placement placed(const SkinPhantom& phantom, const Eigen::Vector3d& spacing_mm) {
  TaskMonitor monitor;
  const auto scan = phantom.scan(spacing_mm, kFrontLow, kFrontHigh);
  return placement(phantom, extractScalp(scan, maskOf(phantom, scan.grid), monitor), scan.grid);
}

/// Blurs by `rounds` of (1 2 1) / 4 along each axis; the outermost voxels keep their values.
volume::Volume blurred(volume::Volume scan, int rounds) {
  const std::size_t strides[3] = {1, std::size_t(scan.grid.size[0]),
                                  std::size_t(scan.grid.size[0]) * std::size_t(scan.grid.size[1])};
  for (int round = 0; round < rounds; ++round)
    for (const std::size_t stride : strides) {
      const auto before = scan.voxels;
      for (std::size_t i = stride; i + stride < before.size(); ++i)
        scan.voxels[i] = 0.25f * before[i - stride] + 0.5f * before[i] + 0.25f * before[i + stride];
    }
  return scan;
}

TEST(ScalpSurface, LiesOnTheSkinThoughFatBelowADarkDermisIsBrighter) {
  // 2 mm of dermis at 3/8 of the fat's level: half of the fat's maximum would lie 1.6 mm deep, its steepest
  // slope 2 mm.
  for (const Eigen::Vector3d& spacing :
       {Eigen::Vector3d(0.67, 0.7, 0.67), Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(1.4, 0.9, 1.1)})
    for (const double dermis_level : {45.0, 90.0}) {
      SkinPhantom phantom;
      phantom.dermis_level = dermis_level;
      const Placement p = placed(phantom, spacing);
      EXPECT_NEAR(p.mean_mm, 0.0, 0.12) << spacing.transpose() << " mm, dermis " << dermis_level;
      EXPECT_NEAR(p.nose_mean_mm, 0.0, 0.15) << spacing.transpose() << " mm, dermis " << dermis_level;
      EXPECT_LT(p.rms_mm, 0.2) << spacing.transpose() << " mm, dermis " << dermis_level;
    }
}

TEST(ScalpSurface, IntensityScaleOffsetAndNoiseDoNotMoveIt) {
  SkinPhantom phantom;
  phantom.dermis_mm = 0;
  phantom.noise = 5;
  EXPECT_NEAR(placed(phantom, {1, 1, 1}).mean_mm, 0.0, 0.06);
  phantom.scale = 0.01;
  phantom.offset = -7;
  EXPECT_NEAR(placed(phantom, {1, 1, 1}).mean_mm, 0.0, 0.06);
}

TEST(ScalpSurface, DermisThatNoVoxelResolvesPullsItLessThanItsThickness) {
  SkinPhantom phantom;
  phantom.dermis_mm = 1.0;
  const Placement p = placed(phantom, {1, 1, 1});
  EXPECT_GT(p.mean_mm, -0.8);
  EXPECT_LT(p.mean_mm, 0.1);
}

TEST(ScalpSurface, AirSetToZeroBelowAThresholdDoesNotMoveItOutwards) {
  SkinPhantom phantom;
  phantom.dermis_mm = 0;
  TaskMonitor monitor;
  auto scan = phantom.scan({1, 1, 1}, kFrontLow, kFrontHigh);
  // Blurred like a mean of many scans, then cut at a tenth of the skin's level, as in Colin27.
  scan = blurred(scan, 3);
  const float level = volume::percentile(scan, 0.99), cut = 0.1f * level;
  const auto whole = placement(phantom, extractScalp(scan, maskOf(phantom, scan.grid), monitor), scan.grid);
  for (float& value : scan.voxels) value = value < cut ? 0.f : value;
  const auto masked = placement(phantom, extractScalp(scan, maskOf(phantom, scan.grid), monitor), scan.grid);
  EXPECT_NEAR(masked.mean_mm, whole.mean_mm, 0.15) << "1 mm and more outside with the cut's step";
  EXPECT_LT(masked.rms_mm, whole.rms_mm + 0.1);
}

TEST(ScalpSurface, IsDoubtedBeneathAPadAndNowhereElse) {
  SkinPhantom phantom;
  phantom.dermis_mm = 0;
  TaskMonitor monitor;
  auto scan = phantom.scan({1, 1, 1}, kFrontLow, kFrontHigh);
  const auto head = maskOf(phantom, scan.grid);
  for (int k = 0; k < scan.grid.size[2]; ++k)  // against the left half of the front
    for (int j = 0; j < scan.grid.size[1]; ++j)
      for (int i = 0; i < scan.grid.size[0]; ++i) {
        const Eigen::Vector3d p = scan.grid.toMri({double(i), double(j), double(k)}).mm;
        if (p.x() < -20 && phantom.toSkin(p) > 0 && phantom.toSkin(p) < 12)
          scan.voxels[scan.grid.index(i, j, k)] = 0.5f * float(phantom.fat_level);
      }
  const auto scalp = extractScalp(scan, head, monitor);
  ASSERT_EQ(scalp.doubt_mm.size(), scalp.mesh.vertices_mm.size());
  const Point<Mri> padded(-45, 76, -10), clear(45, 76, -10);
  EXPECT_GT(skinDoubtUnder_mm(scalp, padded), 0.7);
  EXPECT_LT(skinDoubtUnder_mm(scalp, clear), 0.15);
  EXPECT_EQ(skinDoubtUnder_mm(scalp, Point<Mri>(0, 0, 900)), 0);
}

/// Doubt of clear skin on the front of the phantom.
double doubtInFront_mm(const SkinPhantom& phantom, const volume::Volume& scan) {
  TaskMonitor monitor;
  const auto scalp = extractScalp(scan, maskOf(phantom, scan.grid), monitor);
  return skinDoubtUnder_mm(scalp, Point<Mri>(45, 76, -10));
}

/// Changes the values by their distance to the skin, mm.
template <class Change>
volume::Volume changedOutside(const SkinPhantom& phantom, volume::Volume scan, Change&& changed) {
  std::size_t v = 0;
  for (int k = 0; k < scan.grid.size[2]; ++k)
    for (int j = 0; j < scan.grid.size[1]; ++j)
      for (int i = 0; i < scan.grid.size[0]; ++i, ++v) {
        const double away_mm = phantom.toSkin(scan.grid.toMri({double(i), double(j), double(k)}).mm);
        if (away_mm > 0) scan.voxels[v] = float(changed(scan.voxels[v], away_mm));
      }
  return scan;
}

TEST(ScalpSurface, IsDoubtedInEvenHazeOnAllSides) {
  SkinPhantom phantom;
  phantom.dermis_mm = 0;
  const auto scan = phantom.scan({1, 1, 1}, kFrontLow, kFrontHigh);
  const auto hazy = changedOutside(phantom, scan, [&](float value, double away_mm) {
    return value + (away_mm < 10 ? 0.3 * phantom.fat_level : 0.0);
  });
  EXPECT_LT(doubtInFront_mm(phantom, scan), 0.15) << "no haze";
  EXPECT_GT(doubtInFront_mm(phantom, hazy), 0.5);
}

TEST(ScalpSurface, IsNotDoubtedForAirThatAProgramErasedFarFromTheHead) {
  SkinPhantom phantom;
  phantom.dermis_mm = 0;
  phantom.offset = 30;  // the air's own level
  const auto scan = phantom.scan({1, 1, 1}, kFrontLow, kFrontHigh);
  const double whole_mm = doubtInFront_mm(phantom, scan);
  EXPECT_LT(whole_mm, 0.15);
  for (const float erased : {0.f, -5.f}) {
    const auto blanked = changedOutside(
        phantom, scan, [&](float value, double away_mm) { return away_mm > 12 ? erased : value; });
    EXPECT_NEAR(doubtInFront_mm(phantom, blanked), whole_mm, 0.05) << "erased to " << erased;
  }
}

TEST(ScalpSurface, IsNotDoubtedWhereFatBelowTheSkinIsBrighter) {
  // Fat near below the skin on one side, none on the other; air set to zero, as in Colin27.
  SkinPhantom lean, fat;
  lean.dermis_mm = 7, lean.dermis_level = 60;
  fat.dermis_mm = 2.5, fat.dermis_level = 60, fat.fat_level = 160;
  TaskMonitor monitor;
  auto scan = blurred(lean.scan({1, 1, 1}, kFrontLow, kFrontHigh), 2);
  const auto other = blurred(fat.scan({1, 1, 1}, kFrontLow, kFrontHigh), 2);
  for (int k = 0; k < scan.grid.size[2]; ++k)
    for (int j = 0; j < scan.grid.size[1]; ++j)
      for (int i = 0; i < scan.grid.size[0]; ++i) {
        const std::size_t v = scan.grid.index(i, j, k);
        if (scan.grid.toMri({double(i), double(j), double(k)}).mm.x() < 0) scan.voxels[v] = other.voxels[v];
        if (scan.voxels[v] < 6) scan.voxels[v] = 0;
      }
  const auto scalp = extractScalp(scan, maskOf(lean, scan.grid), monitor);
  for (const double x : {-45, 45})
    EXPECT_LT(skinDoubtUnder_mm(scalp, Point<Mri>(x, 76, -10)), 0.3) << "at " << x << " mm";
}

TEST(ScalpSurface, NormalsPointOutwardsAndTrianglesAgree) {
  for (const bool is_flipped : {false, true}) {
    SkinPhantom phantom;
    auto scan = phantom.scan({1.5, 1.5, 1.5});
    if (is_flipped) {  // the same head stored with i running to the left: a left-handed grid
      for (int k = 0; k < scan.grid.size[2]; ++k)
        for (int j = 0; j < scan.grid.size[1]; ++j)
          std::reverse(&scan.voxels[scan.grid.index(0, j, k)],
                       &scan.voxels[scan.grid.index(0, j, k)] + scan.grid.size[0]);
      scan.grid.mri_from_voxel.translation() = scan.grid.toMri({scan.grid.size[0] - 1.0, 0, 0}).mm;
      scan.grid.mri_from_voxel.linear().col(0) *= -1;
    }
    TaskMonitor monitor;
    const auto scalp = extractScalp(scan, maskOf(phantom, scan.grid), monitor);
    double six_volumes = 0, worst = 1;
    for (const auto& t : scalp.mesh.triangles)
      six_volumes +=
          scalp.mesh.vertices_mm[t[0]].dot(scalp.mesh.vertices_mm[t[1]].cross(scalp.mesh.vertices_mm[t[2]]));
    for (std::size_t v = 0; v < scalp.mesh.normals.size(); ++v)
      if (!phantom.isNearCrease(scalp.mesh.vertices_mm[v]))
        worst = std::min(worst, scalp.mesh.normals[v].dot(scalp.mesh.vertices_mm[v].normalized()));
    EXPECT_NEAR(six_volumes / 6 / 1000, 4.0 / 3 * M_PI * 75 * 95 * 115 / 1000, 150)
        << "ml, flipped: " << is_flipped;
    EXPECT_GT(worst, 0.0);
  }
}

TEST(ScalpSurface, IsOpenWhereTheScanEnds) {
  SkinPhantom phantom;
  TaskMonitor monitor;
  const auto scan = phantom.scan({1.5, 1.5, 1.5}, kFrontLow, kFrontHigh);
  const auto scalp = extractScalp(scan, maskOf(phantom, scan.grid), monitor);
  ASSERT_EQ(scalp.field_of_view.size(), 6u);
  int on_an_end = 0;
  for (const auto& [point, normal] : scalp.field_of_view) {
    EXPECT_LT((scan.grid.centre().mm - point.mm).dot(normal.v), 0) << "normals point out of the scan";
    for (std::size_t v = 0; v < scalp.mesh.vertices_mm.size(); ++v)
      on_an_end += std::abs((scalp.mesh.vertices_mm[v] - point.mm).dot(normal.v)) < 0.5 &&
                   scalp.mesh.normals[v].dot(normal.v) > 0.9;
  }
  EXPECT_EQ(on_an_end, 0) << "no cap over the cut";
}

TEST(ScalpSurface, IsKnownBitForBitAsItsFileGivesItBack) {
  SkinPhantom phantom;
  TaskMonitor monitor;
  auto scan = phantom.scan({2, 2, 2}, kFrontLow, kFrontHigh);
  auto head = maskOf(phantom, scan.grid);
  scan.grid.mri_from_voxel.prerotate(
      Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, -2, 0.7).normalized()));  // planes with oblique normals
  head.grid = scan.grid;
  const auto scalp = extractScalp(scan, head, monitor);
  TemporaryFolder folder;
  writeScalp(scalp, folder.path() / "scalp.vtp");
  const auto read = readScalp(folder.path() / "scalp.vtp"), stored = asStored(scalp);
  EXPECT_TRUE(read.mesh.vertices_mm == stored.mesh.vertices_mm);
  EXPECT_TRUE(read.mesh.normals == stored.mesh.normals);
  EXPECT_FALSE(read.mesh.normals == scalp.mesh.normals) << "then nothing is tested";
  ASSERT_EQ(read.field_of_view.size(), stored.field_of_view.size());
  for (std::size_t p = 0; p < read.field_of_view.size(); ++p) {
    EXPECT_TRUE(read.field_of_view[p].first.mm == stored.field_of_view[p].first.mm);
    EXPECT_TRUE(read.field_of_view[p].second.v == stored.field_of_view[p].second.v);
  }
}

TEST(ScalpSurface, SurvivesTheFile) {
  SkinPhantom phantom;
  TaskMonitor monitor;
  const auto scan = phantom.scan({2, 2, 2}, kFrontLow, kFrontHigh);
  auto scalp = extractScalp(scan, maskOf(phantom, scan.grid), monitor);
  scalp.has_face = true;
  scalp.findings = {"nose tip cut by the scan's edge", "an ear is cut"};
  scalp.has_cut_ear = true;
  TemporaryFolder folder;
  writeScalp(scalp, folder.path() / "scalp.vtp");
  const auto read = readScalp(folder.path() / "scalp.vtp");
  EXPECT_TRUE(read.has_face);
  EXPECT_TRUE(read.has_cut_ear);
  EXPECT_EQ(read.findings, scalp.findings);
  EXPECT_EQ(read.mesh.triangles, scalp.mesh.triangles);
  EXPECT_EQ(read.doubt_mm, scalp.doubt_mm);
  ASSERT_EQ(read.mesh.vertices_mm.size(), scalp.mesh.vertices_mm.size());
  EXPECT_LT((read.mesh.vertices_mm[100] - scalp.mesh.vertices_mm[100]).norm(), 1e-6);
  ASSERT_EQ(read.field_of_view.size(), 6u);
  EXPECT_LT((read.field_of_view[3].first.mm - scalp.field_of_view[3].first.mm).norm(), 1e-9);
  EXPECT_FALSE(read.measurement);
  EXPECT_THROW(readScalp(folder.path() / "absent.vtp"), Error);
}

TEST(ScalpSurface, OfAMeasuredFaceKeepsItsErrorsInTheFile) {
  ScalpSurface face;
  face.mesh.vertices_mm = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  face.mesh.normals.assign(3, Eigen::Vector3d::UnitZ());
  face.mesh.triangles = {{0, 1, 2}};
  face.measurement = FaceMeasurement{15400, 0.4, 0.1, 0.2};
  TemporaryFolder folder;
  writeScalp(face, folder.path() / "face.vtp");
  auto read = readScalp(folder.path() / "face.vtp");
  ASSERT_TRUE(read.measurement);
  EXPECT_EQ(read.measurement->points, 15400);
  EXPECT_EQ(read.measurement->point_mm, 0.4);
  EXPECT_EQ(read.measurement->sight_mm, 0.1);
  EXPECT_EQ(read.measurement->whole_mm, 0.2);
  EXPECT_FALSE(read.measurement->size) << "not known";
  face.measurement->size = 0.003;
  writeScalp(face, folder.path() / "face.vtp");
  read = readScalp(folder.path() / "face.vtp");
  EXPECT_EQ(read.measurement->size, 0.003);
  face.measurement->whole_mm = -1;
  writeScalp(face, folder.path() / "face.vtp");
  EXPECT_THROW(readScalp(folder.path() / "face.vtp"), Error);
}

}  // namespace
}  // namespace facenav::surface
