// Labels and lobes of synthetic label maps, and atlas maps whose values are known; files that are no atlas.

#include <gmock/gmock.h>

#include <fstream>

#include "facenav/atlas/atlas_map.h"
#include "facenav/atlas/lobes.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/volume/nifti.h"
#include "support/matchers.h"
#include "support/test_data.h"

namespace facenav::atlas {
namespace {

using testing::EigenNear;

/// 40^3 voxels about the origin; label 1 at one voxel, 2 at another.
LabelMap twoVoxels(const Eigen::Vector3d& spacing_mm, const Eigen::Vector3i& one,
                   const Eigen::Vector3i& two) {
  LabelMap map;
  map.labels.grid.size = {40, 40, 40};
  map.labels.grid.mri_from_voxel.linear() = spacing_mm.asDiagonal();
  map.labels.grid.mri_from_voxel.translation() = -20 * spacing_mm;
  map.labels.voxels.assign(40 * 40 * 40, 0.f);
  map.labels.voxels[map.labels.grid.index(one[0], one[1], one[2])] = 1;
  map.labels.voxels[map.labels.grid.index(two[0], two[1], two[2])] = 2;
  map.names = {{1, "one"}, {2, "two"}};
  return map;
}

Point<Mni> centreOf(const LabelMap& map, const Eigen::Vector3i& voxel) {
  return Point<Mni>(map.labels.grid.mri_from_voxel * voxel.cast<double>());
}

TEST(LabelAt, IsTheVoxelsLabelAllOverTheVoxel) {
  const Eigen::Vector3d spacing_mm(2, 2, 2);
  const auto map = twoVoxels(spacing_mm, {10, 20, 30}, {11, 20, 30});
  const Eigen::Vector3d centre = centreOf(map, {10, 20, 30}).mm;
  EXPECT_EQ(labelAt(map, Point<Mni>(centre + Eigen::Vector3d(0.99, 0, 0))).name, "one");
  EXPECT_EQ(labelAt(map, Point<Mni>(centre + Eigen::Vector3d(1.01, 0, 0))).name, "two");
  EXPECT_EQ(labelAt(map, Point<Mni>(centre + Eigen::Vector3d(-0.9, 0.9, 0.9))).distance_mm, 0.0);
}

TEST(LabelAt, TheDistanceIsToTheVoxelsEdgeInMillimetres) {
  const auto map = twoVoxels({1, 2, 3}, {20, 20, 20}, {0, 0, 0});
  for (int axis = 0; axis < 3; ++axis) {
    const double half_mm = 0.5 * (axis + 1);
    const auto label = labelAt(map, Point<Mni>(4.0 * Eigen::Vector3d::Unit(axis)), 5.0);
    EXPECT_EQ(label.name, "one");
    EXPECT_NEAR(label.distance_mm, 4.0 - half_mm, 1e-9) << axis;
  }
}

TEST(LabelAt, EndsAtTheSearchDistance) {
  const auto map = twoVoxels({1, 1, 1}, {20, 20, 20}, {0, 0, 0});
  EXPECT_EQ(labelAt(map, {5.4, 0, 0}, 5.0).name, "one");
  EXPECT_EQ(labelAt(map, {5.6, 0, 0}, 5.0).name, "");
  EXPECT_EQ(labelAt(map, {3, 0, 0}, 2.0).name, "");
  EXPECT_EQ(labelAt(map, {3, 0, 0}, 3.0).name, "one");
}

TEST(LabelAt, TheNearerOfTwoWins) {
  const auto map = twoVoxels({1, 1, 1}, {18, 20, 20}, {23, 20, 20});
  EXPECT_EQ(labelAt(map, {0, 0, 0}, 5).name, "one");
  EXPECT_EQ(labelAt(map, {1, 0, 0}, 5).name, "two");
}

TEST(LabelAt, IgnoresLabelsWithoutAName) {
  auto map = twoVoxels({1, 1, 1}, {20, 20, 20}, {22, 20, 20});
  map.names.erase(1);
  const auto label = labelAt(map, {0, 0, 0}, 5);
  EXPECT_EQ(label.name, "two");
  EXPECT_NEAR(label.distance_mm, 1.5, 1e-9);
}

TEST(LabelAt, HoldsForAGridThatCountsFromTheRight) {
  auto map = twoVoxels({-1, 1, 1}, {10, 20, 20}, {30, 20, 20});
  EXPECT_EQ(labelAt(map, {10, 0, 0}, 1).name, "one") << "x = 20 - 10";
  EXPECT_EQ(labelAt(map, {-10, 0, 0}, 1).name, "two");
}

/// Lobe of one label in the middle, under its AAL name.
std::string lobeOf(const std::string& aal, const Point<Mni>& at = {0, 0, 0}) {
  LabelMap map = twoVoxels({1, 1, 1}, {0, 0, 0}, {0, 0, 0});
  std::fill(map.labels.voxels.begin(), map.labels.voxels.end(), 0.f);
  for (int k = 18; k < 23; ++k)
    for (int j = 18; j < 23; ++j)
      for (int i = 18; i < 23; ++i) map.labels.voxels[map.labels.grid.index(i, j, k)] = 1;
  map.names = {{1, aal}};
  return LobeMap(map).at(at);
}

TEST(Lobes, TheMostSpecificNameCounts) {
  EXPECT_EQ(lobeOf("Temporal_Pole_Sup_L"), "left temporal pole");
  EXPECT_EQ(lobeOf("Temporal_Inf_R"), "right underside of the temporal lobe");
  EXPECT_EQ(lobeOf("Temporal_Mid_R"), "right temporal lobe");
  EXPECT_EQ(lobeOf("Frontal_Sup_Orb_R"), "right underside of the frontal lobe");
  EXPECT_EQ(lobeOf("Frontal_Sup_L"), "left frontal lobe");
  EXPECT_EQ(lobeOf("Cingulum_Ant_L"), "left frontal lobe");
  EXPECT_EQ(lobeOf("Cingulum_Post_L"), "left parietal lobe");
  EXPECT_EQ(lobeOf("Vermis_6"), "cerebellum") << "no side in the middle";
  EXPECT_EQ(lobeOf("Somewhere_L"), "");
}

TEST(Lobes, ReachBeyondTheirLabelsByTwentyMillimetresAtMost) {
  EXPECT_EQ(lobeOf("Precentral_L", {12, 0, 0}), "left motor strip");
  EXPECT_EQ(lobeOf("Precentral_L", {-19, 0, 0}), "left motor strip");
  EXPECT_EQ(lobeOf("Precentral_L", {400, 0, 0}), "");
}

TEST(Lobes, MeetHalfWayBetweenTwoLabels) {
  auto map = twoVoxels({1, 1, 1}, {10, 20, 20}, {30, 20, 20});
  map.names = {{1, "Precentral_L"}, {2, "Precentral_R"}};
  const LobeMap lobes(map);
  EXPECT_EQ(lobes.at({-7, 0, 0}), "left motor strip");
  EXPECT_EQ(lobes.at({7, 0, 0}), "right motor strip");
}

volume::VoxelGrid mniGrid() {
  volume::VoxelGrid grid;
  grid.size = {11, 11, 11};
  grid.mri_from_voxel = Eigen::Translation3d(-50, -50, -50) * Eigen::Scaling(10.0);
  return grid;
}

AtlasMap mapWith(const Eigen::Affine3d& affine, const Eigen::Vector3f& shift_mm) {
  return AtlasMap(affine, mniGrid(), std::vector<Eigen::Vector3f>(mniGrid().count(), shift_mm));
}

TEST(AtlasMapValues, WithoutAWarpItIsTheAffine) {
  const Eigen::Affine3d affine = Eigen::Translation3d(3, -4, 5) *
                                 Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitY()) *
                                 Eigen::Scaling(1.1, 0.9, 1.2);
  const auto map = mapWith(affine, {0, 0, 0});
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(-37, -21, 58), {0, 0, 0}, {120, 5, -90}}) {
    EXPECT_THAT(map.toMri(Point<Mni>(p)).mm, EigenNear(affine * p, 1e-9));
    EXPECT_THAT(map.toMni(Point<Mri>(affine * p)).mm, EigenNear(p, 0.01));
  }
}

TEST(AtlasMapValues, TheWarpComesBeforeTheAffine) {
  const Eigen::Affine3d turned(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()));  // x goes to y
  const auto map = mapWith(turned, {4, 0, 0});
  EXPECT_THAT(map.toMri(Point<Mni>(10, 0, 0)).mm, EigenNear(Eigen::Vector3d(0, 14, 0), 1e-9));
  EXPECT_THAT(map.toMni(Point<Mri>(0, 14, 0)).mm, EigenNear(Eigen::Vector3d(10, 0, 0), 0.01));
}

TEST(AtlasMapValues, LeftStaysLeft) {
  const auto map = mapWith(Eigen::Affine3d(Eigen::Scaling(1.05)), {0.5f, -1, 2});
  EXPECT_LT(map.toMri(Point<Mni>(-37, -21, 58)).mm.x(), -30);
  EXPECT_GT(map.toMri(Point<Mni>(37, -21, 58)).mm.x(), 30);
}

TEST(AtlasMapValues, IsLinearBetweenTheNodes) {
  std::vector<Eigen::Vector3f> displacement(mniGrid().count(), Eigen::Vector3f::Zero());
  displacement[mniGrid().index(6, 5, 5)] = {8, 0, 0};  // at x = 10 mm
  const AtlasMap map(Eigen::Affine3d::Identity(), mniGrid(), displacement);
  const auto shift = [&](double x, double y) { return map.toMri(Point<Mni>(x, y, 0)).mm.x() - x; };
  EXPECT_NEAR(shift(10, 0), 8, 1e-6);
  EXPECT_NEAR(shift(5, 0), 4, 1e-6);
  EXPECT_NEAR(shift(2.5, 5), 1, 1e-6);
  EXPECT_NEAR(shift(0, 0), 0, 1e-6);
  EXPECT_NEAR(shift(20, 0), 0, 1e-6);
}

TEST(AtlasMapValues, NeedsOneDisplacementPerNode) {
  EXPECT_THROW(AtlasMap(Eigen::Affine3d::Identity(), mniGrid(), std::vector<Eigen::Vector3f>(5)),
               std::logic_error);
}

TEST(AtlasFile, CutAnywhereItIsAnErrorAndNoCrash) {
  const testing::TemporaryFolder folder;
  const auto path = folder.path() / "atlas.vti";
  std::vector<Eigen::Vector3f> displacement;  // values that hardly compress
  for (std::size_t n = 0; n < mniGrid().count(); ++n)
    displacement.push_back({float(n * 7919 % 1009) / 100, 2, float(n * 104729 % 997) / 100});
  writeAtlasMap(AtlasMap(Eigen::Affine3d::Identity(), mniGrid(), displacement), path);
  const std::string whole = readWholeFile(path);
  ASSERT_GT(whole.size(), 1000u);
  for (const double share : {0.02, 0.2, 0.5, 0.8, 0.95}) {
    std::ofstream(path, std::ios::binary) << whole.substr(0, std::size_t(share * double(whole.size())));
    EXPECT_THROW(readAtlasMap(path), Error) << share;
  }
  std::ofstream(path, std::ios::binary) << whole;
  EXPECT_NEAR(readAtlasMap(path).toMri(Point<Mni>(0, 0, 0)).mm.y(), 2, 0.006);
}

TEST(AtlasFile, AnImageOfAnotherKindIsRefused) {
  const testing::TemporaryFolder folder;
  const auto path = folder.path() / "atlas.vti";
  writeAtlasMap(mapWith(Eigen::Affine3d::Identity(), {1, 2, 3}), path);
  std::string text = readWholeFile(path);
  for (const std::string name : {"displacement_0.01mm", "mri_from_mni"}) {
    std::string other = text;
    const auto at = other.find(name);
    ASSERT_NE(at, std::string::npos);
    for (auto next = at; next != std::string::npos; next = other.find(name, next)) other[next] = 'X';
    std::ofstream(path, std::ios::binary) << other;
    EXPECT_THROW(readAtlasMap(path), Error) << name;
  }
}

TEST(BrainTemplateFiles, NamesThatAreMissingAreAnErrorThatNamesTheFile) {
  const testing::TemporaryFolder folder;
  volume::Volume tiny;
  tiny.grid.size = {3, 3, 3};
  tiny.voxels.assign(27, 1.f);
  for (const char* file : {"ch2bet.nii.gz", "aal.nii.gz", "brodmann.nii.gz"})
    volume::writeNifti(tiny, folder.path() / file);
  try {
    readColin27(folder.path());
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("aal.nii.txt"));
  }
  std::ofstream(folder.path() / "aal.nii.txt") << "1 Precentral_L 2001\n\nno number\n2 Precentral_R 2002\n";
  const auto colin = readColin27(folder.path());
  EXPECT_EQ(colin.aal.names, (std::map<int, std::string>{{1, "Precentral_L"}, {2, "Precentral_R"}}));
  EXPECT_EQ(colin.brodmann.names.at(4), "BA 4");
  EXPECT_EQ(colin.brodmann.names.count(0), 0u) << "0 is no label";
}

}  // namespace
}  // namespace facenav::atlas
