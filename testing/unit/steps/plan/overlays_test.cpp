#include "facenav/plan/overlays.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/volume/nifti.h"
#include "support/ball_case.h"
#include "support/test_data.h"

namespace facenav::steps {
namespace {

namespace fs = std::filesystem;
using casefile::OverlayKind;
using casefile::OverlaySpace;

class Overlays : public ::testing::Test {
 protected:
  casefile::CaseStore caseWith(bool has_atlas) {
    auto prepared = testing::ballCase();
    if (has_atlas) {  // MNI lies 10 mm to the right of this head's own position, without rotation
      volume::VoxelGrid nodes;
      nodes.size = {2, 2, 2};
      nodes.mri_from_voxel.linear() *= 200.0;
      nodes.mri_from_voxel.translation().setConstant(-100);
      Eigen::Affine3d mri_from_mni = Eigen::Affine3d::Identity();
      mri_from_mni.translation() << -10, 0, 0;
      prepared.atlas =
          atlas::AtlasMap(mri_from_mni, nodes, std::vector<Eigen::Vector3f>(8, Eigen::Vector3f::Zero()));
    }
    return casefile::CaseStore::create(folder_.path() / "case", prepared, {}, false);
  }
  /// Map with values 1..5 and a peak of 5 at `peak_mm`; 3 mm voxels.
  fs::path mapWithPeak(const Eigen::Vector3d& peak_mm) {
    volume::Volume map;
    map.grid.size = {55, 55, 55};
    map.grid.mri_from_voxel.linear() *= 3.0;
    map.grid.mri_from_voxel.translation().setConstant(-81);
    for (int k = 0; k < 55; ++k)
      for (int j = 0; j < 55; ++j)
        for (int i = 0; i < 55; ++i) {
          const double d_mm = (map.grid.toMri(Eigen::Vector3d(i, j, k)).mm - peak_mm).norm();
          map.voxels.push_back(d_mm < 16 ? float(5 - d_mm / 4) : 0.f);
        }
    volume::writeNifti(map, folder_.path() / "patient_smith.nii.gz");
    return folder_.path() / "patient_smith.nii.gz";
  }
  testing::TemporaryFolder folder_;
};

Eigen::Vector3d peakOf(const volume::Volume& map) {
  const auto at = std::max_element(map.voxels.begin(), map.voxels.end()) - map.voxels.begin();
  const auto& grid = map.grid;
  return grid.mri_from_voxel * Eigen::Vector3d(double(at % grid.size[0]),
                                               double(at / grid.size[0] % grid.size[1]),
                                               double(at / (grid.size[0] * grid.size[1])));
}

TEST_F(Overlays, AMapIsKeptWithTheCaseWithoutTheNameOfItsFile) {
  const auto store = caseWith(false);
  const auto file = mapWithPeak({-30, 12, 45});
  NewOverlay wanted;
  wanted.file = file, wanted.threshold = 2.0;
  const auto entry = addOverlay(store, wanted);
  fs::remove(file);
  EXPECT_EQ(entry.name, "map 1");
  const auto loaded = loadOverlays(store, store.mri().grid);
  ASSERT_EQ(loaded.size(), 1u);
  ASSERT_TRUE(loaded[0].map);
  EXPECT_LT((peakOf(*loaded[0].map) - Eigen::Vector3d(-30, 12, 45)).norm(), 1e-3);
  EXPECT_EQ(loaded[0].threshold, 2.0);
  EXPECT_NEAR(loaded[0].full, 5.0, 1e-6);
  EXPECT_EQ(readWholeFile(store.folder() / "overlays.json").find("smith"), std::string::npos);
  for (const auto& each : fs::recursive_directory_iterator(store.folder()))
    EXPECT_EQ(each.path().string().find("smith"), std::string::npos);
  EXPECT_EQ(fs::status(store.folder() / entry.file).permissions() & fs::perms::all, fs::perms(0600));
}

TEST_F(Overlays, AnMniMapIsCarriedIntoTheHeadByTheAtlas) {
  const auto store = caseWith(true);
  NewOverlay wanted;
  wanted.file = mapWithPeak({-30, 12, 45});
  wanted.space = OverlaySpace::mni;
  addOverlay(store, wanted);
  const auto loaded = loadOverlays(store, store.mri().grid);
  ASSERT_TRUE(loaded.at(0).map);
  EXPECT_LT((peakOf(*loaded[0].map) - Eigen::Vector3d(-40, 12, 45)).norm(), 1.5);
}

TEST_F(Overlays, MniWithoutAnAtlasIsRefusedAndNothingIsLeft) {
  const auto store = caseWith(false);
  NewOverlay wanted;
  wanted.file = mapWithPeak({-30, 12, 45});
  wanted.space = OverlaySpace::mni;
  EXPECT_THROW(addOverlay(store, wanted), Error);
  EXPECT_FALSE(fs::exists(store.folder() / "overlays.json"));
  EXPECT_FALSE(fs::exists(store.folder() / "overlays"));
}

TEST_F(Overlays, WhatLiesBesideTheHeadIsRefused) {
  const auto store = caseWith(false);
  surface::TractLines tracts;
  for (int i = 0; i < 100; ++i) tracts.points_mm.emplace_back(200 + i, 0, 0);
  tracts.ends = {100};
  surface::writeTck(tracts, folder_.path() / "far.tck");
  NewOverlay wanted;
  wanted.file = folder_.path() / "far.tck";
  EXPECT_THROW(addOverlay(store, wanted), Error);
  EXPECT_TRUE(casefile::readOverlays(store.folder()).empty());
}

TEST_F(Overlays, AFileOfZeroAndOneIsAMask) {
  const auto store = caseWith(false);
  volume::Mask ball;
  ball.grid = store.mri().grid;
  for (std::size_t i = 0; i < ball.grid.count(); ++i) ball.voxels.push_back(i % 97 == 0);
  volume::writeMask(ball, folder_.path() / "lesion.nii.gz");
  NewOverlay wanted;
  wanted.file = folder_.path() / "lesion.nii.gz";
  EXPECT_EQ(addOverlay(store, wanted).kind, OverlayKind::mask);
  EXPECT_TRUE(loadOverlays(store, ball.grid).at(0).mask);
}

TEST_F(Overlays, TractsAndSurfacesComeBackWhereTheyWere) {
  const auto store = caseWith(true);
  surface::TractLines tracts;
  tracts.points_mm = {{-40, 10, 50}, {-41, 11, 51}};
  tracts.ends = {2};
  surface::writeTck(tracts, folder_.path() / "a.tck");
  NewOverlay wanted;
  wanted.file = folder_.path() / "a.tck";
  wanted.space = OverlaySpace::mni;
  addOverlay(store, wanted);
  std::ofstream(folder_.path() / "b.obj") << "v -40 10 50\nv -20 10 50\nv -40 30 50\nf 1 2 3\n";
  wanted.file = folder_.path() / "b.obj";
  wanted.space.reset();
  addOverlay(store, wanted);
  const auto loaded = loadOverlays(store, store.mri().grid);
  ASSERT_EQ(loaded.size(), 2u);
  EXPECT_LT((loaded[0].tracts->tracts.points_mm[0] - Eigen::Vector3f(-50, 10, 50)).norm(), 0.01f);
  EXPECT_LT((loaded[1].mesh->vertices_mm[2] - Eigen::Vector3d(-40, 30, 50)).norm(), 1e-4);
}

TEST_F(Overlays, ChangesAreKeptAndRemovingTakesTheCopyAway) {
  const auto store = caseWith(false);
  NewOverlay wanted;
  wanted.file = mapWithPeak({-30, 12, 45});
  wanted.name = "finger tapping";
  auto entry = addOverlay(store, wanted);
  EXPECT_THROW(addOverlay(store, wanted), Error) << "the name is taken";
  entry.opacity = 0.25, entry.threshold = 3.5, entry.unit = "t";
  changeOverlay(store, entry);
  const auto read = casefile::readOverlays(store.folder());
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].opacity, 0.25);
  EXPECT_EQ(read[0].threshold, 3.5);
  EXPECT_EQ(read[0].unit, "t");
  removeOverlay(store, "finger tapping");
  EXPECT_TRUE(casefile::readOverlays(store.folder()).empty());
  EXPECT_TRUE(fs::is_empty(store.folder() / "overlays"));
  EXPECT_THROW(removeOverlay(store, "finger tapping"), Error);
}

TEST_F(Overlays, ADamagedListIsRefusedByItsKey) {
  const auto store = caseWith(false);
  std::ofstream(store.folder() / "overlays.json")
      << R"({"overlays": [{"name": "a", "kind": "map", "file": "/etc/passwd", "space": "native", "opacity": 1}]})";
  try {
    casefile::readOverlays(store.folder());
    ADD_FAILURE() << "a file outside the case was accepted";
  } catch (const Error& fault) {
    EXPECT_THAT(fault.what(), ::testing::HasSubstr("overlays[0].file"));
  }
}

}  // namespace
}  // namespace facenav::steps
