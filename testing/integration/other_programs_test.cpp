// facenav export --as and facenav import with files of other programs, as a user runs them.

#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "facenav/casefile/kept_session.h"
#include "facenav/core/whole_file.h"
#include "facenav/dicom/series.h"
#include "facenav/geometry/pose_error.h"
#include "facenav/volume/nifti.h"
#include "support/ball_case.h"
#include "support/command_line.h"
#include "support/made_session.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using Json = nlohmann::json;

guidance::Target targetOn(const std::string& name, const Eigen::Vector3d& direction) {
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), -direction);
  guidance::Target target;
  target.name = name;
  target.mri_T_target = {turn, 92.0 * direction.normalized()};
  target.cortex_point = Point<Mri>(60.0 * direction.normalized());
  target.scalp_point = Point<Mri>(90.0 * direction.normalized());
  return target;
}

class OtherPrograms : public ::testing::Test {
 protected:
  OtherPrograms() {
    guidance::TreatmentPlan plan;
    plan.targets = {targetOn("M1 hand L", {-0.5, 0.1, 0.8}), targetOn("左 DLPFC", {-0.5, 0.6, 0.6})};
    full_.setTargets(plan);
  }
  fs::path at(const std::string& name) const { return folder_.path() / name; }
  std::string quoted(const fs::path& path) const { return "'" + path.string() + "'"; }
  CommandResult exportAs(const std::string& format, const fs::path& file, const std::string& more = "") {
    return runFacenav("export " + quoted(full_.folder()) + " --as " + format + " -o " + quoted(file) + " " +
                      more);
  }
  CommandResult import(const fs::path& file, const std::string& more = "") {
    return runFacenav("import " + quoted(empty_.folder()) + " " + quoted(file) + " " + more);
  }
  TemporaryFolder folder_;
  casefile::CaseStore full_ = casefile::CaseStore::create(at("full"), ballWithBrain(), {}, false);
  casefile::CaseStore empty_ = casefile::CaseStore::create(at("empty"), ballWithBrain(), {}, false);
};

TEST_F(OtherPrograms, TargetsGoOutAndComeBackWithTheirOrigin) {
  ASSERT_EQ(exportAs("brainsight", at("out.dat")).status, 0);
  const auto preview = import(at("out.dat"), "--dry-run");
  EXPECT_EQ(preview.status, 0) << preview.errors;
  EXPECT_THAT(preview.output, HasSubstr("added     target    'M1 hand L'"));
  EXPECT_TRUE(empty_.targets().targets.empty()) << "a preview writes nothing";
  const auto imported = import(at("out.dat"), "--by A.R.");
  ASSERT_EQ(imported.status, 0) << imported.errors;
  const auto plan = empty_.targets();
  ASSERT_EQ(plan.targets.size(), 2u);
  const auto before = full_.targets();
  for (const auto& target : plan.targets) {
    const auto& old = before.find(target.name);
    EXPECT_LT(poseError(target.mri_T_target, old.mri_T_target).translation_mm, 1e-4);
    EXPECT_THAT(target.note, HasSubstr("out.dat (Brainsight text export, version 12"));
    EXPECT_EQ(target.changes.front().by, "A.R.");
  }
  const auto again = import(at("out.dat"));
  EXPECT_EQ(again.status, 0) << again.errors;
  EXPECT_THAT(again.output, HasSubstr("0 targets added, 2 there already"));
}

TEST_F(OtherPrograms, EveryFormatIsKnownByItsContent) {
  for (const char* format : {"brainsight", "localite", "simnibs-csv", "simnibs-mat", "visor2", "softaxic",
                             "mkss", "mrk.json", "navinibs", "csv", "json"}) {
    const auto file = at(std::string("file_") + format + ".bin");
    ASSERT_EQ(exportAs(format, file).status, 0) << format;
    const auto result = import(file, "--dry-run --json");
    ASSERT_EQ(result.status, 0) << format << ": " << result.errors;
    const auto json = Json::parse(result.output);
    EXPECT_EQ(json["format"], format);
    EXPECT_EQ(json["items"][0]["name"], "M1 hand L") << format;
    EXPECT_EQ(json["items"][1]["name"], "左 DLPFC") << format;
    EXPECT_EQ(json["items"][0]["mri_T_coil"].size(), 16u) << format;
  }
  EXPECT_EQ(exportAs("simnibs-py", at("script.py")).status, 0);
  EXPECT_EQ(exportAs("tfm", at("one.tfm")).status, 1) << "two targets";
  EXPECT_EQ(exportAs("tfm", at("one.tfm"), "--target 'M1 hand L'").status, 0);
}

TEST_F(OtherPrograms, OneRefusedItemStopsTheImport) {
  ASSERT_EQ(exportAs("simnibs-csv", at("two.csv")).status, 0);
  std::ofstream(at("two.csv"), std::ios::app) << "CoilPos,0,0,900,0,0,-1,0,1,0,0,far\n";
  const auto refused = import(at("two.csv"));
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.errors,
              HasSubstr("target 'far' (line 3): its centre lies 900 mm from the middle of the head"));
  EXPECT_EQ(std::count(refused.errors.begin(), refused.errors.end(), '\n'), 1);
  EXPECT_TRUE(empty_.targets().targets.empty());
  EXPECT_EQ(import(at("two.csv"), "--skip-refused").status, 0);
  EXPECT_EQ(empty_.targets().targets.size(), 2u);
}

TEST_F(OtherPrograms, AnotherPoseUnderAnOldNameIsAsked) {
  guidance::TreatmentPlan plan;
  plan.targets = {targetOn("M1 hand L", {0.5, 0.1, 0.8})};
  empty_.setTargets(plan);
  ASSERT_EQ(exportAs("localite", at("markers.xml")).status, 0);
  const auto refused = import(at("markers.xml"));
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.errors, HasSubstr("--replace"));
  EXPECT_EQ(import(at("markers.xml"), "--replace").status, 0);
  const auto moved = empty_.targets().find("M1 hand L");
  EXPECT_LT(moved.mri_T_target.translation_mm().x(), 0.0);
}

TEST_F(OtherPrograms, PulsesBecomeASession) {
  writeMadeSession(full_.folder(), full_.targets().targets.front(), {});
  ASSERT_EQ(exportAs("brainsight", at("all.txt")).status, 0);
  EXPECT_THAT(readText(at("all.txt")), HasSubstr("# Sample Name\tSession Name"));
  const auto imported = import(at("all.txt"));
  ASSERT_EQ(imported.status, 0) << imported.errors;
  const auto sessions = casefile::sessionFolders(empty_.folder());
  ASSERT_EQ(sessions.size(), 1u);
  const auto before = casefile::readSessionPulses(casefile::sessionFolders(full_.folder()).front()).pulses;
  const auto after = casefile::readSession(sessions.front()).pulses.pulses;
  std::size_t with_pose = 0;
  for (const auto& pulse : before) {
    if (!pulse.pulse.mri_T_coil()) continue;
    ASSERT_LT(with_pose, after.size());
    const auto& same = after[with_pose++].pulse;
    EXPECT_EQ(same.utc, pulse.pulse.utc);
    EXPECT_EQ(same.target->name, "M1 hand L");
    EXPECT_LT(poseError(*same.mri_T_coil(), *pulse.pulse.mri_T_coil()).translation_mm, 1e-3);
  }
  EXPECT_EQ(with_pose, after.size());
  EXPECT_TRUE(fs::exists(sessions.front() / "imported.json"));
  EXPECT_EQ(import(at("all.txt")).status, 0);
  EXPECT_EQ(casefile::sessionFolders(empty_.folder()).size(), 1u) << "a second import changes nothing";
  EXPECT_EQ(runFacenav("pulses " + quoted(empty_.folder())).status, 0);
  EXPECT_EQ(runFacenav("sessions " + quoted(empty_.folder())).status, 0);
}

TEST_F(OtherPrograms, AWholeCaseGoesOutAsADataSetAndComesBack) {
  writeMadeSession(full_.folder(), full_.targets().targets.front(), {});
  full_.setLabel("Anna Example");
  EXPECT_EQ(exportAs("nibs-bids", at("set"), "--subject 'Anna E'").status, 1) << "no label";
  ASSERT_EQ(exportAs("nibs-bids", at("set"), "--subject P17").status, 0);
  EXPECT_EQ(readText(at("set/sub-P17/anat/sub-P17_T1w.nii.gz")), readText(full_.folder() / "mri.nii.gz"));
  EXPECT_EQ(exportAs("nibs-bids", at("set")).status, 1) << "not empty";
  ASSERT_EQ(exportAs("nibs-bids", at("set"), "--replace").status, 0);
  std::string names;
  for (const auto& entry : fs::recursive_directory_iterator(at("set"))) {
    names += entry.path().string() + "\n";
    if (entry.is_regular_file()) EXPECT_THAT(readText(entry.path()), ::testing::Not(HasSubstr("Anna")));
  }
  EXPECT_THAT(names, ::testing::Not(HasSubstr("P17"))) << "replaced as a whole";
  EXPECT_THAT(names, ::testing::Not(HasSubstr("Anna"))) << "the label is no code";
  const auto imported = import(at("set"));
  ASSERT_EQ(imported.status, 0) << imported.errors;
  EXPECT_EQ(empty_.targets().targets.size(), 2u);
  const auto sessions = casefile::sessionFolders(empty_.folder());
  ASSERT_EQ(sessions.size(), 1u);
  const auto before = casefile::readSessionPulses(casefile::sessionFolders(full_.folder()).front()).pulses;
  const auto after = casefile::readSessionPulses(sessions.front()).pulses;
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < after.size(); ++i) {
    EXPECT_EQ(after[i].pulse.mri_T_coil().has_value(), before[i].pulse.mri_T_coil().has_value());
    EXPECT_NEAR(*after[i].pulse.t_s, *before[i].pulse.t_s - *before[0].pulse.t_s, 2e-3);
    if (after[i].pulse.mri_T_coil())
      EXPECT_LT(poseError(*after[i].pulse.mri_T_coil(), *before[i].pulse.mri_T_coil()).translation_mm, 1e-5);
  }
  EXPECT_EQ(import(at("set")).status, 0);
  EXPECT_EQ(casefile::sessionFolders(empty_.folder()).size(), 1u) << "a second import changes nothing";
}

TEST_F(OtherPrograms, OnlyADataSetOfFacenavIsReplaced) {
  fs::create_directories(at("home"));
  std::ofstream(at("home/thesis.txt")) << "work";
  EXPECT_EQ(exportAs("nibs-bids", at("home"), "--replace").status, 1);
  EXPECT_TRUE(fs::exists(at("home/thesis.txt")));
  EXPECT_EQ(exportAs("nibs-bids", "-").status, 1);
  EXPECT_EQ(exportAs("csv", at("t.csv"), "--subject a").status, 2);
}

TEST_F(OtherPrograms, ADataSetOfAnotherT1OrWithADoubtfulHandleIsRefused) {
  ASSERT_EQ(exportAs("nibs-bids", at("set"), "--subject a").status, 0);
  const auto system = at("set/sub-a/nibs/sub-a_task-tms_coordsystem.json");
  std::string text = readText(system);
  text.replace(text.find("y points away from the handle"), 29, "y runs along the handle");
  writeWholeFile(system, text);
  const auto asked = import(at("set"));
  EXPECT_EQ(asked.status, 1);
  EXPECT_THAT(asked.errors, HasSubstr("its handle points"));
  EXPECT_THAT(asked.errors, HasSubstr("--y-sign as-written or --y-sign flipped"));
  EXPECT_EQ(import(at("set"), "--y-sign as-written --dry-run").status, 0);
  EXPECT_EQ(import(at("set"), "--flip-handle --dry-run").status, 0);
  EXPECT_EQ(import(at("set"), "--flip-handle --y-sign as-written").status, 2);
  volume::Volume other = full_.mri();
  for (auto& voxel : other.voxels) voxel = float(std::hash<float>()(voxel + 1) % 100);
  other.grid.size[2] -= 2;
  other.voxels.resize(other.grid.count());
  volume::writeNifti(other, at("set/sub-a/anat/sub-a_T1w.nii.gz"));
  const auto refused = import(at("set"), "--y-sign as-written");
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.errors, HasSubstr("its T1 is another one: 50 x 50 x 48 voxels"));
}

TEST_F(OtherPrograms, ExportsAreForTheUserAloneAndReplaceNothingUnasked) {
  ASSERT_EQ(exportAs("csv", at("t.csv")).status, 0);
  EXPECT_EQ(fs::status(at("t.csv")).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(exportAs("csv", at("t.csv")).status, 1);
  EXPECT_EQ(exportAs("csv", at("t.csv"), "--replace").status, 0);
  EXPECT_EQ(exportAs("csv", "-").status, 0);
  EXPECT_EQ(exportAs("csv stl", at("t")).status, 2);
  EXPECT_EQ(runFacenav("export " + quoted(full_.folder()) + " --as stl").status, 2)
      << "surfaces need a folder";
}

TEST_F(OtherPrograms, ThePlanGoesToTheArchiveAsASeriesOfTheSamePatient) {
  dicom::writeSeries(ballWithBrain().mri, at("dicom"), {});
  const std::string source = " --source " + quoted(at("dicom")), target = " --target 'M1 hand L'";
  const auto unnamed = exportAs("dicom-mr", at("plan"), target);
  EXPECT_EQ(unnamed.status, 2);
  EXPECT_THAT(unnamed.errors, HasSubstr("give their folder with --source"));
  EXPECT_EQ(exportAs("stl", at("plan"), source).status, 2);
  const auto several = exportAs("dicom-mr", at("plan"), source);
  EXPECT_EQ(several.status, 1);
  EXPECT_THAT(several.errors, HasSubstr("has 2 targets"));
  const auto written = exportAs("dicom-mr", at("plan"), source + target);
  ASSERT_EQ(written.status, 0) << written.errors;
  EXPECT_THAT(written.output, HasSubstr("50 images"));
  EXPECT_EQ(exportAs("dicom-mr", at("plan"), source + target).status, 1) << "nothing is replaced unasked";
  EXPECT_EQ(exportAs("dicom-seg", at("plan.dcm"), source + target + " --target '左 DLPFC'").status, 0);
  EXPECT_EQ(exportAs("dicom-seg", at("plan.dcm"), source + target).status, 1);
  const auto listed = Json::parse(runFacenav("series " + quoted(at("plan")) + " --json --patients").output);
  ASSERT_EQ(listed.size(), 1u);
  EXPECT_THAT(listed[0].dump(), HasSubstr("FaceNav, not for diagnosis: M1 hand L"));
  EXPECT_THAT(listed[0].dump(), HasSubstr("marks are drawn into its voxels"));
  EXPECT_EQ(runFacenav("prepare " + quoted(at("plan")) + " -o " + quoted(at("again"))).status, 1);
}

TEST_F(OtherPrograms, DamagedFilesAreOneLine) {
  writeWholeFile(at("cut.txt"), "# Version: 12\n# Coordinate system: NIfTI:Aligned\n# Target Name\tLoc. X\n");
  for (const auto& [name, content] : std::map<std::string, std::string>{{"empty", ""},
                                                                        {"noise", std::string(500, '\x01')},
                                                                        {"xml", "<InstrumentMarkerList>"},
                                                                        {"json", "{\"markups\": ["}})
    std::ofstream(at(name)) << content;
  for (const char* name : {"cut.txt", "empty", "noise", "xml", "json", "absent"}) {
    const auto result = import(at(name));
    EXPECT_EQ(result.status, 1) << name;
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
  }
}

}  // namespace
}  // namespace facenav::testing
