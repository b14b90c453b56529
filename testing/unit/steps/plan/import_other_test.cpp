// Several files of other programs at once: what is said before, what is left out, all or nothing; and what a
// dropped path is.

#include "facenav/plan/import_other.h"

#include <gmock/gmock.h>

#include "facenav/casefile/kept_session.h"
#include "facenav/core/error.h"
#include "facenav/plan/other_files.h"
#include "support/ball_case.h"
#include "support/coil_positions.h"
#include "support/test_data.h"

namespace facenav::steps {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class ImportsOfSeveral : public ::testing::Test {
 protected:
  fs::path write(const std::string& name, const std::string& content) const {
    return testing::writtenFile(folder_.path() / name, content);
  }
  std::vector<PreviewedFile> preview(const std::vector<OtherImport>& orders) const {
    return previewImports(store_, caseHead(store_), orders);
  }
  static OtherImport order(const fs::path& file) {
    OtherImport order;
    order.file = file;
    order.skips_refused = true;
    return order;
  }
  ImportedItems take(const std::vector<PreviewedFile>& files) const {
    return importOthers(store_, files, [this](const auto& plan) { store_.setTargets(plan); });
  }
  testing::TemporaryFolder folder_;
  casefile::CaseStore store_ =
      casefile::CaseStore::create(folder_.path() / "case", testing::ballCase(), {}, false);
};

TEST_F(ImportsOfSeveral, ATargetOfOneFileCountsForTheNext) {
  const auto first = write("a.csv", testing::coilPosition("M1", {-1, 0, 1}));
  const auto same =
      write("b.csv", testing::coilPosition("M1", {-1, 0, 1}) + testing::coilPosition("SMA", {0, 1, 2}));
  const auto other = write("c.csv", testing::coilPosition("M1", {1, 0, 1}));
  const auto noise = write("d.csv", "no list of targets");
  const auto files = preview({order(first), order(same), order(other), order(noise)});
  ASSERT_EQ(files.size(), 4u);
  EXPECT_EQ(files[0].preview.items[0].fate, ItemFate::added);
  EXPECT_EQ(files[1].preview.items[0].fate, ItemFate::unchanged);
  EXPECT_EQ(files[1].preview.items[1].fate, ItemFate::added);
  EXPECT_EQ(files[2].preview.items[0].fate, ItemFate::refused);
  EXPECT_THAT(files[2].preview.items[0].reason, HasSubstr("a file before it has a target of this name"));
  EXPECT_THAT(files[3].failure, HasSubstr("no file of a navigator"));
  EXPECT_TRUE(store_.targets().targets.empty()) << "a preview writes nothing";
  EXPECT_EQ(take(files).targets, 2);
  EXPECT_EQ(store_.targets().targets.size(), 2u);
}

TEST_F(ImportsOfSeveral, WhatIsLeftOutStaysOutAndFreesItsName) {
  auto first = order(
      write("a.csv", testing::coilPosition("M1", {-1, 0, 1}) + testing::coilPosition("SMA", {0, 1, 2})));
  first.left_out_targets = {"M1"};
  const auto second = order(write("b.csv", testing::coilPosition("M1", {1, 0, 1})));
  const auto files = preview({first, second});
  EXPECT_EQ(files[0].preview.items[0].fate, ItemFate::left_out);
  EXPECT_EQ(files[1].preview.items[0].fate, ItemFate::added);
  take(files);
  EXPECT_GT(store_.targets().find("M1").mri_T_target.translation_mm().x(), 0);
}

TEST_F(ImportsOfSeveral, EverySessionOfAFileComesInOnce) {
  auto pulses = order(write("pulses.csv", testing::twoSessionsOfPulses()));
  pulses.left_out_sessions = {"second"};
  EXPECT_EQ(take(preview({pulses})).pulses, 2);
  pulses.left_out_sessions.clear();
  const auto rest = preview({pulses});
  EXPECT_EQ(rest[0].preview.items[0].fate, ItemFate::unchanged);
  EXPECT_EQ(rest[0].preview.items[2].fate, ItemFate::added);
  EXPECT_EQ(take(rest).sessions.size(), 1u);
  EXPECT_EQ(casefile::sessionFolders(store_.folder()).size(), 2u);
  EXPECT_EQ(preview({pulses})[0].preview.pulses(), 0);
}

TEST_F(ImportsOfSeveral, SessionsWithoutATimeGetFoldersOfTheirOwn) {
  const auto files =
      preview({order(write("a.csv", testing::twoSessionsOfPulses())),
               order(write("b.csv", testing::twoSessionsOfPulses() + "pulse,,0,0,92,0,1,0,0,,third,\n"))});
  const auto imported = take(files);
  EXPECT_EQ(imported.sessions.size(), 5u);
  EXPECT_EQ(casefile::sessionFolders(store_.folder()).size(), 5u);
  EXPECT_EQ(imported.pulses, 7);
}

TEST_F(ImportsOfSeveral, APlanThatCannotBeWrittenLeavesNoSession) {
  const auto files = preview({order(write("a.csv", testing::coilPosition("M1", {-1, 0, 1}))),
                              order(write("b.csv", testing::twoSessionsOfPulses()))});
  EXPECT_THROW(importOthers(store_, files, [](const auto&) { throw Error("the disk is full"); }), Error);
  EXPECT_TRUE(casefile::sessionFolders(store_.folder()).empty());
  EXPECT_TRUE(store_.targets().targets.empty());
}

TEST_F(ImportsOfSeveral, ADroppedPathIsOfAnotherProgramAScanOrNeither) {
  const auto positions = write("positions.dat", testing::coilPosition("M1", {-1, 0, 1}));
  const auto marked = write("marked.csv", "\xEF\xBB\xBF" + testing::coilPosition("M1", {-1, 0, 1}));
  const auto noise = write("noise.bin", std::string(300, '\x01'));
  const auto slice = write("IM0001", std::string(128, '\0') + "DICM" + std::string(100, '\0'));
  EXPECT_THAT(filesAt(positions).others, ElementsAre(positions));
  EXPECT_THAT(filesAt(marked).others, ElementsAre(marked)) << "with a byte order mark";
  EXPECT_FALSE(filesAt(positions).may_be_scan);
  for (const auto& neither : {noise, folder_.path() / "absent"}) {
    EXPECT_TRUE(filesAt(neither).others.empty());
    EXPECT_FALSE(filesAt(neither).may_be_scan);
  }
  EXPECT_TRUE(filesAt(slice).may_be_scan);
  EXPECT_TRUE(filesAt(store_.folder() / "mri.nii.gz").may_be_scan);
  const auto mesh = write("sim.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n");
  EXPECT_THAT(filesAt(mesh).fields, ElementsAre(mesh));
  EXPECT_TRUE(filesAt(slice).fields.empty());
  EXPECT_TRUE(filesAt(folder_.path()).may_be_scan) << "DICOM beside it";
  const auto session = folder_.path() / "session" / "InstrumentMarkers";
  fs::create_directories(session);
  const auto markers =
      testing::writtenFile(session / "Marker.xml", "<?xml version=\"1.0\"?><InstrumentMarkerList>");
  testing::writtenFile(session / "readme.txt", "words");
  EXPECT_THAT(filesAt(folder_.path() / "session").others, ElementsAre(markers));
  EXPECT_FALSE(filesAt(folder_.path() / "session").may_be_scan);
}

TEST_F(ImportsOfSeveral, ASetThatIsRefusedSaysItsReasonOnce) {
  std::string far;
  for (const char* name : {"a", "b", "c"}) far += testing::coilPosition(name, {0, 0, 1}, 900);
  const auto file = write(
      "far.csv", far + testing::coilPosition("d", {0, 1, 0}, 700) + testing::coilPosition("M1", {-1, 0, 1}));
  const auto preview = previewImport(store_, order(file));
  const auto refused = preview.refusals();
  ASSERT_EQ(refused.size(), 2u);
  EXPECT_THAT(refused[0].items, ElementsAre(0, 1, 2));
  EXPECT_THAT(refused[0].reason, HasSubstr("900 mm"));
  EXPECT_THAT(preview.refusal(), HasSubstr("3 items, the first target 'a'"));
  EXPECT_THAT(preview.refusal(), ::testing::EndsWith("; and 1 more"));
}

}  // namespace
}  // namespace facenav::steps
