#include "facenav/casefile/case_store.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "made_case.h"
#include "support/matchers.h"
#include "support/test_data.h"

namespace facenav::casefile {
namespace {
namespace fs = std::filesystem;
using namespace casefile::testing;
using facenav::testing::EigenNear;
using facenav::testing::TemporaryFolder;

int mode(const fs::path& path) {
  struct stat status {};
  EXPECT_EQ(::stat(path.c_str(), &status), 0) << path;
  return int(status.st_mode & 0777);
}

template <class Action>
std::string faultOf(Action action) {
  try {
    action();
  } catch (const Error& fault) {
    return fault.what();
  }
  return "";
}

std::size_t entries(const fs::path& folder) {
  return std::size_t(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(CaseStore, GivesBackWhatWasPrepared) {
  const TemporaryFolder folder;
  const PreparedCase prepared = preparedCase();
  const CaseStore made = CaseStore::create(folder.path() / "case", prepared, provenance(), false);
  const CaseStore store = CaseStore::open(folder.path() / "case");
  EXPECT_TRUE(store.mri().grid.matches(prepared.mri.grid));
  EXPECT_EQ(store.mri().voxels, prepared.mri.voxels);
  EXPECT_EQ(store.mri().orientation_source, "DICOM");
  EXPECT_EQ(store.headMask().voxels, prepared.head_mask.voxels);
  ASSERT_TRUE(store.brainMask() && store.brain());
  EXPECT_EQ(store.brainMask()->voxels, prepared.brain_mask->voxels);
  EXPECT_TRUE(store.scalp().has_face);
  ASSERT_EQ(store.scalp().mesh.vertices_mm.size(), 6u);
  EXPECT_THAT(store.scalp().mesh.vertices_mm[2], EigenNear(prepared.scalp.mesh.vertices_mm[2], 1e-4));
  EXPECT_EQ(store.brain()->mesh.triangles.size(), 8u);
  EXPECT_EQ(store.findings(), prepared.findings);
  EXPECT_EQ(store.caseId(), made.caseId());
  ASSERT_EQ(store.provenance().size(), 1u);
  EXPECT_EQ(store.provenance()[0].input_sha256.at("mri"), std::string(64, 'a'));
  EXPECT_TRUE(store.targets().targets.empty());
  EXPECT_FALSE(store.alignment());
}

TEST(CaseStore, KeepsTheSettingsThatDifferedAndNothingWhereNoneDid) {
  const TemporaryFolder folder;
  auto steps = provenance();
  CaseStore::create(folder.path() / "plain", preparedCase(), steps, false);
  EXPECT_EQ(readWholeFile(folder.path() / "plain/case.json").find("settings"), std::string::npos);
  steps[0].settings = {{"segmentation.search_mm", 9.5}};
  const CaseStore changed = CaseStore::create(folder.path() / "changed", preparedCase(), steps, false);
  EXPECT_EQ(changed.provenance().at(0).settings, steps[0].settings);
}

TEST(CaseStore, KeepsWhatPrepareThinksOfItsBrain) {
  const TemporaryFolder folder;
  PreparedCase prepared = preparedCase();
  EXPECT_FALSE(CaseStore::create(folder.path() / "without", prepared, provenance(), false).brainQuality());
  prepared.brain_quality =
      BrainQuality{{{"left temporal pole", 0.625, 4.25}, {"cerebellum", 1, 0.5}}, 0.75, 3.5, 0.25, 1.5};
  CaseStore::create(folder.path() / "case", prepared, provenance(), false);
  const auto quality = CaseStore::open(folder.path() / "case").brainQuality();
  ASSERT_TRUE(quality);
  ASSERT_EQ(quality->regions.size(), 2u);
  EXPECT_EQ(quality->regions[0].region, "left temporal pole");
  EXPECT_DOUBLE_EQ(quality->regions[0].confidence, 0.625);
  EXPECT_DOUBLE_EQ(quality->regions[0].doubt_mm, 4.25);
  EXPECT_DOUBLE_EQ(quality->surface_median_mm, 0.75);
  EXPECT_DOUBLE_EQ(quality->surface_p95_mm, 3.5);
  EXPECT_DOUBLE_EQ(quality->model_median_mm, 0.25);
  EXPECT_DOUBLE_EQ(quality->model_p95_mm, 1.5);
}

TEST(CaseStore, KeepsAHeadWithoutABrain) {
  const TemporaryFolder folder;
  CaseStore::create(folder.path() / "case", withoutBrain(), provenance(), false);
  const CaseStore store = CaseStore::open(folder.path() / "case");
  EXPECT_FALSE(store.brainMask());
  EXPECT_FALSE(store.brain());
  EXPECT_FALSE(fs::exists(folder.path() / "case/brain.vtp"));
}

registration::SkinModel skinOf(const surface::ScalpSurface& scalp) {
  return {{scalp.mesh.vertices_mm, scalp.mesh.normals},
          scalp.mesh.triangles,
          scalp.field_of_view,
          scalp.has_face};
}

TEST(CaseStore, KeepsTheScalpsFieldSoThatAligningNeedNotBuildIt) {
  const TemporaryFolder folder;
  PreparedCase prepared = preparedCase();
  prepared.scalp_field =
      std::make_shared<const registration::ScalpField>(skinOf(surface::asStored(prepared.scalp)));
  const CaseStore store = CaseStore::create(folder.path() / "case", prepared, provenance(), false);
  EXPECT_TRUE(registration::ScalpField::read(skinOf(store.scalp()), store.scalpField()));
  EXPECT_EQ(mode(store.scalpField()), 0600);
}

TEST(CaseStore, CarriesALabelOnlyWhenGivenOneAndKeepsItWhenReplaced) {
  const TemporaryFolder folder;
  const CaseStore store = CaseStore::create(folder.path() / "case", preparedCase(), {}, false);
  EXPECT_EQ(store.label(), "");
  EXPECT_EQ(readWholeFile(folder.path() / "case/case.json").find("label"), std::string::npos);
  store.setLabel("  Doe,\tJane\n");
  EXPECT_EQ(store.label(), "Doe, Jane");
  EXPECT_EQ(mode(folder.path() / "case/case.json"), 0600);
  CaseStore::create(folder.path() / "case", preparedCase(), {}, true);
  EXPECT_EQ(store.label(), "Doe, Jane");
  PreparedCase labelled = preparedCase();
  labelled.label = "Roe";
  CaseStore::create(folder.path() / "case", labelled, {}, true);
  EXPECT_EQ(store.label(), "Roe");
  EXPECT_NE(faultOf([&] { store.setLabel(std::string(kLongestLabel + 1, 'x')); }).find("longer than 120"),
            std::string::npos);
  EXPECT_EQ(store.label(), "Roe");
  store.setLabel("");
  EXPECT_EQ(store.label(), "");
}

TEST(CaseStore, IsPrivateToTheUser) {
  const TemporaryFolder folder;
  const CaseStore store = CaseStore::create(folder.path() / "case", preparedCase(), provenance(), false);
  store.setTargets(onePlan());
  writeAlignment({}, store.folder() / "alignment.json");
  EXPECT_EQ(mode(folder.path() / "case"), 0700);
  for (const auto& entry : fs::directory_iterator(folder.path() / "case"))
    EXPECT_EQ(mode(entry.path()), 0600) << entry;
}

TEST(CaseStore, ReplacingKeepsIdTargetsSessionsAndThresholdsButNoStaleAlignment) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "case";
  const CaseStore before = CaseStore::create(path, preparedCase(), provenance(), false);
  const std::string id = before.caseId();
  before.setTargets(onePlan());
  writeAlignment({}, path / "alignment.json");
  fs::create_directories(path / "sessions/20260101T000000Z");
  writeWholeFile(path / "sessions/20260101T000000Z/poses.csv", "x");
  fs::create_directories(path / "thresholds");
  writeWholeFile(path / "thresholds/20260101T000000Z.jsonl", "found");
  const CaseStore after = CaseStore::create(path, withoutBrain(), provenance(), true);
  EXPECT_EQ(after.caseId(), id);
  EXPECT_EQ(after.targets().targets.size(), 1u);
  EXPECT_TRUE(fs::exists(path / "sessions/20260101T000000Z/poses.csv"));
  EXPECT_EQ(readWholeFile(path / "thresholds/20260101T000000Z.jsonl"), "found");
  EXPECT_FALSE(after.alignment());
  EXPECT_FALSE(after.brain());
  EXPECT_EQ(entries(folder.path()), 1u) << "no temporary folder is left";
}

/// Reverses axis i of the scan.
PreparedCase countedBackwards(PreparedCase prepared) {
  auto& mri = prepared.mri;
  const int last = mri.grid.size[0] - 1;
  mri.grid.mri_from_voxel.translation() = mri.grid.toMri({double(last), 0, 0}).mm;
  mri.grid.mri_from_voxel.linear().col(0) *= -1;
  for (std::size_t row = 0; row < mri.voxels.size(); row += std::size_t(last) + 1)
    std::reverse(mri.voxels.begin() + std::ptrdiff_t(row),
                 mri.voxels.begin() + std::ptrdiff_t(row) + last + 1);
  return prepared;
}

TEST(CaseStore, TargetsAreNotMovedByReplacingTheirScanInSilence) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "case";
  CaseStore::create(path, preparedCase(), provenance(), false).setTargets(onePlan());
  PreparedCase mirrored = preparedCase(), shifted = preparedCase();
  mirrored.mri.grid.mri_from_voxel =
      Eigen::Affine3d(Eigen::Scaling(-1.0, 1.0, 1.0)) * mirrored.mri.grid.mri_from_voxel;
  shifted.mri.grid.mri_from_voxel.translation().x() += 3;
  for (const PreparedCase& other : {mirrored, shifted})
    EXPECT_NE(faultOf([&] { CaseStore::create(path, other, provenance(), true); }).find("point elsewhere"),
              std::string::npos);
  EXPECT_NO_THROW(CaseStore::create(path, countedBackwards(preparedCase()), provenance(), true));
  CaseStore::open(path).setTargets({});
  EXPECT_NO_THROW(CaseStore::create(path, mirrored, provenance(), true));
}

TEST(CaseStore, PosesOfSessionsAreNotMovedByReplacingTheirScan) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "case";
  CaseStore::create(path, preparedCase(), provenance(), false);
  fs::create_directories(path / "sessions/20260101T000000Z");
  PreparedCase shifted = preparedCase();
  shifted.mri.grid.mri_from_voxel.translation().x() += 3;
  const auto fault = [&] { return faultOf([&] { CaseStore::create(path, shifted, provenance(), true); }); };
  EXPECT_NE(fault().find("the poses of its sessions would point elsewhere; make a new case"),
            std::string::npos);
  EXPECT_EQ(fault().find("remove the targets"), std::string::npos);
  CaseStore::open(path).setTargets(onePlan());
  EXPECT_NE(fault().find("its targets would point elsewhere; make a new case"), std::string::npos);
  EXPECT_EQ(fault().find("remove the targets"), std::string::npos) << "the sessions would stay in the way";
  EXPECT_NO_THROW(CaseStore::create(path, countedBackwards(preparedCase()), provenance(), true));
  EXPECT_TRUE(fs::exists(path / "sessions/20260101T000000Z"));
}

TEST(CaseStore, AScanDoesNotReplaceAFaceThatHasSessions) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "case";
  CaseStore::createFromFace(path, {preparedCase().scalp, {}, {}, {}}, {}, false);
  fs::create_directories(path / "sessions/20260101T000000Z");
  const auto fault = faultOf([&] { CaseStore::create(path, preparedCase(), provenance(), true); });
  EXPECT_NE(fault.find("has no MRI"), std::string::npos);
  EXPECT_NE(fault.find("the poses of its sessions would point elsewhere"), std::string::npos);
  EXPECT_FALSE(CaseStore::open(path).hasMri());
  fs::remove_all(path / "sessions");
  EXPECT_NO_THROW(CaseStore::create(path, preparedCase(), provenance(), true));
}

TEST(CaseStore, DoesNotTouchWhatItMayNotReplace) {
  const TemporaryFolder folder;
  CaseStore::create(folder.path() / "case", preparedCase(), provenance(), false);
  EXPECT_NE(
      faultOf([&] { CaseStore::create(folder.path() / "case", preparedCase(), {}, false); }).find("exists"),
      std::string::npos);
  fs::create_directory(folder.path() / "photos");
  writeWholeFile(folder.path() / "photos/a.jpg", "x");
  EXPECT_NE(
      faultOf([&] { CaseStore::create(folder.path() / "photos", preparedCase(), {}, true); }).find("no case"),
      std::string::npos);
  EXPECT_TRUE(fs::exists(folder.path() / "photos/a.jpg"));
  EXPECT_EQ(entries(folder.path()), 2u);
}

TEST(CaseStore, LeavesNothingBehindWhenAStepFails) {
  const TemporaryFolder folder;
  const CaseStore before = CaseStore::create(folder.path() / "case", preparedCase(), provenance(), false);
  PreparedCase broken = preparedCase();
  broken.mri.voxels.resize(10);  // fewer voxels than the grid has: writing throws
  EXPECT_ANY_THROW(CaseStore::create(folder.path() / "case", broken, provenance(), true));
  EXPECT_ANY_THROW(CaseStore::create(folder.path() / "new", broken, provenance(), false));
  EXPECT_EQ(entries(folder.path()), 1u);
  EXPECT_TRUE(before.brain());
  EXPECT_NE(
      faultOf([&] { CaseStore::create(folder.path() / "no/case", preparedCase(), {}, false); }).find("no:"),
      std::string::npos);
}

TEST(CaseStore, TakesATrailingSlashAndAnEmptyFolder) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "case");
  CaseStore::create(folder.path().string() + "/case/", preparedCase(), {}, false);
  EXPECT_NO_THROW(CaseStore::open(folder.path().string() + "/case/"));
  EXPECT_EQ(entries(folder.path()), 1u);
}

TEST(CaseStore, OpeningRemovesWhatAProgramLeftThatWasKilledWhileAligning) {
  facenav::testing::TemporaryFolder folder;
  const auto path = folder.path() / "case";
  CaseStore::create(path, preparedCase(), provenance(), false);
  const auto group = path / ".tmp999999999_0_group";
  fs::create_directories(group / "new");
  CaseStore::open(path);
  EXPECT_TRUE(fs::exists(group)) << "it may belong to a program on another machine";
  for (const auto& place : {group, group / "new"})
    fs::last_write_time(place, fs::file_time_type::clock::now() - std::chrono::hours(25));
  CaseStore::open(path);
  EXPECT_FALSE(fs::exists(group));
}

TEST(CaseStore, OpenNamesWhatIsWrong) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "case";
  EXPECT_NE(faultOf([&] { CaseStore::open(path); }).find("no such case"), std::string::npos);
  CaseStore::create(path, preparedCase(), provenance(), false);
  fs::remove(path / "brain_texture.png");
  EXPECT_NE(faultOf([&] { CaseStore::open(path); }).find("brain_texture.png"), std::string::npos);
  writeWholeFile(path / "case.json", R"({"schema_version": 99, "case_id": "x"})");
  EXPECT_NE(faultOf([&] { CaseStore::open(path); }).find("schema version 99"), std::string::npos);
  writeWholeFile(path / "case.json", R"({"schema_version": 1})");
  EXPECT_NE(faultOf([&] { CaseStore::open(path); }).find("case_id"), std::string::npos);
  writeWholeFile(path / "case.json",
                 R"({"schema_version": 1, "case_id": "x", "files": ["../../etc/passwd"]})");
  EXPECT_NE(faultOf([&] { CaseStore::open(path); }).find("files[0]"), std::string::npos);
  fs::remove(path / "case.json");
  EXPECT_NE(faultOf([&] { CaseStore::open(path); }).find("case.json"), std::string::npos);
}

TEST(CaseStore, CaseIdsAreRandom) {
  const TemporaryFolder folder;
  const auto a = CaseStore::create(folder.path() / "a", withoutBrain(), {}, false);
  const auto b = CaseStore::create(folder.path() / "b", withoutBrain(), {}, false);
  EXPECT_EQ(a.caseId().size(), 16u);
  EXPECT_NE(a.caseId(), b.caseId());
}

}  // namespace
}  // namespace facenav::casefile
