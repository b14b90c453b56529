#include "facenav/casefile/sign_off.h"
#include "facenav/casefile/edited_brain.h"

#include <gmock/gmock.h>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/volume/nifti.h"
#include "made_case.h"
#include "support/test_data.h"

namespace facenav::casefile {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

CaseStore madeStore(const fs::path& place, bool replace = false) {
  return CaseStore::create(place, testing::preparedCase(), {}, replace);
}

TEST(SignOff, NamesWhoCheckedAndWhatWasSeen) {
  const facenav::testing::TemporaryFolder folder;
  const auto store = madeStore(folder.path() / "case");
  EXPECT_EQ(stateOf(store), CaseState::prepared);
  signOff(store, {"A. Radiographer", "nose tip is fine", true});
  const auto read = validSignOff(store);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->by, "A. Radiographer");
  EXPECT_EQ(read->note, "nose tip is fine");
  EXPECT_EQ(read->findings_acknowledged, store.findings());
  ASSERT_TRUE(read->brain_ml);
  EXPECT_DOUBLE_EQ(*read->brain_ml, store.brainMask()->volume_ml());
  EXPECT_EQ(stateOf(store), CaseState::checked);
  EXPECT_EQ(fs::status(store.folder() / "sign_off.json").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST(SignOff, IsRefusedWithOpenFindingsOrWithoutAName) {
  const facenav::testing::TemporaryFolder folder;
  const auto store = madeStore(folder.path() / "case");
  EXPECT_THROW(signOff(store, {"", "", true}), Error);
  try {
    signOff(store, {"A. R.", "", false});
    FAIL() << "open findings were passed over";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("the face was removed below the brow"));
  }
  EXPECT_FALSE(fs::exists(store.folder() / "sign_off.json"));
}

TEST(SignOff, IsVoidAndRefusedWhileACorrectionOfTheBrainIsUnderWay) {
  const facenav::testing::TemporaryFolder folder;
  const auto store = madeStore(folder.path() / "case");
  signOff(store, {"A. R.", "", true});
  saveBrainDraft(store, testing::ball(6));
  EXPECT_FALSE(signOffStatus(store).holds());
  EXPECT_EQ(stateOf(store), CaseState::prepared);
  EXPECT_EQ(listCases(folder.path()).front().checked_by, "");
  EXPECT_THROW(signOff(store, {"A. R.", "", true}), Error);
  removeBrainDraft(store);
  EXPECT_EQ(stateOf(store), CaseState::checked);
}

TEST(SignOff, IsVoidOnceTheMaskIsAnother) {
  const facenav::testing::TemporaryFolder folder;
  const auto store = madeStore(folder.path() / "case");
  signOff(store, {"A. R.", "", true});
  auto edited = *store.brainMask();
  edited.voxels.front() = !edited.voxels.front();
  volume::writeMask(edited, store.folder() / "brain_mask.nii.gz");
  EXPECT_FALSE(validSignOff(store));
  EXPECT_EQ(stateOf(store), CaseState::prepared);
}

TEST(SignOff, SaysWhichFileMadeItVoidAndRefusesAnotherCaseThanWasShown) {
  const facenav::testing::TemporaryFolder folder;
  const auto store = madeStore(folder.path() / "case");
  EXPECT_FALSE(signOffStatus(store).last);
  const auto shown = seenFiles(store);
  signOff(store, {"A. R.", "", true, shown});
  EXPECT_TRUE(signOffStatus(store).holds());
  auto edited = *store.brainMask();
  edited.voxels.front() = !edited.voxels.front();
  volume::writeMask(edited, store.folder() / "brain_mask.nii.gz");
  const auto status = signOffStatus(store);
  ASSERT_TRUE(status.last);
  EXPECT_FALSE(status.holds());
  EXPECT_EQ(status.changed, std::vector<std::string>{"brain_mask.nii.gz"});
  EXPECT_THROW(signOff(store, {"A. R.", "", true, shown}), Error);
  EXPECT_FALSE(signOffStatus(store).holds());
}

TEST(SignOff, ACorrectedMaskMakesItVoidAndTheAutomaticOneIsKept) {
  const facenav::testing::TemporaryFolder folder;
  const auto store = madeStore(folder.path() / "case");
  signOff(store, {"A. R.", "", true});
  const auto automatic = *store.brainMask();
  auto edited = automatic;
  edited.voxels.front() = !edited.voxels.front();
  saveBrainDraft(store, edited);
  EXPECT_FALSE(signOffStatus(store).holds());
  EXPECT_TRUE(signOffStatus(store).changed.empty());  // a draft is not yet the case's mask
  EXPECT_EQ(brainDraft(store)->voxels, edited.voxels);
  saveEditedBrainMask(store, edited);
  removeBrainDraft(store);
  EXPECT_FALSE(signOffStatus(store).holds());
  EXPECT_FALSE(brainDraft(store));
  EXPECT_EQ(store.brainMask()->voxels, edited.voxels);
  EXPECT_EQ(automaticBrainMask(store)->voxels, automatic.voxels);
  saveEditedBrainMask(store, automatic);
  EXPECT_EQ(automaticBrainMask(store)->voxels, automatic.voxels);
  EXPECT_EQ(fs::status(store.folder() / "brain_mask.nii.gz").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST(SignOff, DoesNotOutliveTheModel) {
  const facenav::testing::TemporaryFolder folder;
  signOff(madeStore(folder.path() / "case"), {"A. R.", "", true});
  EXPECT_EQ(stateOf(madeStore(folder.path() / "case", true)), CaseState::prepared);
}

TEST(SignOff, ATargetMakesACheckedCasePlannedButNotAnUncheckedOne) {
  const facenav::testing::TemporaryFolder folder;
  const auto store = madeStore(folder.path() / "case");
  guidance::TreatmentPlan plan;
  plan.targets.emplace_back();
  plan.targets.back().name = "M1 hand L";
  store.setTargets(plan);
  EXPECT_EQ(stateOf(store), CaseState::prepared);
  signOff(store, {"A. R.", "", true});
  EXPECT_EQ(stateOf(store), CaseState::planned);
}

TEST(SignOff, AnOverrideIsKeptWithNameAndReason) {
  const facenav::testing::TemporaryFolder folder;
  const auto store = madeStore(folder.path() / "case");
  EXPECT_THROW(recordOverride(store, "B. Clinician", "", "0"), Error);
  recordOverride(store, "B. Clinician", "emergency", "0");
  const auto steps = store.provenance();
  ASSERT_FALSE(steps.empty());
  EXPECT_EQ(steps.back().step, "override");
  EXPECT_EQ(steps.back().options.at("by"), "B. Clinician");
  EXPECT_EQ(steps.back().options.at("reason"), "emergency");
}

TEST(Worklist, ListsCasesWithStateAndNamesTheDamagedLast) {
  const facenav::testing::TemporaryFolder folder;
  fs::create_directory(folder.path() / "no_case");
  fs::create_directory(folder.path() / "a_damaged");
  writeWholeFile(folder.path() / "a_damaged/case.json", "{");
  madeStore(folder.path() / "b_prepared");
  signOff(madeStore(folder.path() / "c_checked"), {"A. R.", "", true});
  const auto entries = listCases(folder.path());
  ASSERT_EQ(entries.size(), 3u);
  EXPECT_THAT(entries.back().problem, HasSubstr("case.json"));
  for (const auto& entry : entries) {
    if (!entry.problem.empty()) continue;
    const bool is_checked = entry.folder.filename() == "c_checked";
    EXPECT_EQ(entry.state, is_checked ? CaseState::checked : CaseState::prepared);
    EXPECT_EQ(entry.checked_by, is_checked ? "A. R." : "");
    EXPECT_EQ(entry.findings.size(), 1u);
  }
  EXPECT_THROW(listCases(folder.path() / "nowhere"), Error);
}

TEST(Worklist, TakesOverWhatDidNotChangeAndReadsAnewWhatDid) {
  const facenav::testing::TemporaryFolder folder;
  const auto store = madeStore(folder.path() / "case");
  auto known = listCases(folder.path());
  ASSERT_EQ(known.size(), 1u);
  known.front().checked_by = "taken over";  // marks a reused entry
  EXPECT_EQ(listCases(folder.path(), known).front().checked_by, "taken over");
  signOff(store, {"A. R.", "", true});
  EXPECT_EQ(listCases(folder.path(), known).front().checked_by, "A. R.");
}

}  // namespace
}  // namespace facenav::casefile
