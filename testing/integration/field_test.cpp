// facenav field on a small case: what a person reads, what a program reads, the files, and wrong input.

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "facenav/plan/plan_edits.h"
#include "support/ball_case.h"
#include "support/command_line.h"
#include "support/made_field_mesh.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

class Field : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto store = casefile::CaseStore::create(case_, ballWithBrain(), {}, false);
    const auto head = steps::plannedHead(store);
    store.setTargets({{steps::targetOverCortex(head, "hotspot", Point<Mri>(0, 0, 40)),
                       steps::targetOverCortex(head, "deep", Point<Mri>(-28, 0, 20))}});
  }
  CommandResult field(const std::string& arguments) const {
    return runFacenav("field '" + case_.string() + "' " + arguments);
  }
  std::string at(const std::string& name) const { return "'" + (folder_.path() / name).string() + "'"; }
  TemporaryFolder folder_;
  fs::path case_ = folder_.path() / "case";
};

TEST_F(Field, SaysStrengthPlaceAndModel) {
  const auto run = field("--target hotspot --coil figure8-70 --didt 66");
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_THAT(run.output,
              AllOf(HasSubstr("figure-8 70 mm (built in), 42 dipoles"), HasSubstr("tier 0: a sphere"),
                    HasSubstr("usual error 28 %"), HasSubstr("at target"), HasSubstr("V/m at 1 A/us)"),
                    HasSubstr("maximum"), HasSubstr("above 90 %")));
}

TEST_F(Field, AnswersAProgram) {
  const auto run =
      field("--target deep --coil figure8-70 --hotspot hotspot --threshold 50 --best normal --arrows --json");
  ASSERT_EQ(run.status, 0) << run.errors;
  const auto json = nlohmann::json::parse(run.output);
  EXPECT_EQ(json["tier"], 0);
  EXPECT_TRUE(json["rate_a_per_us"].is_null());
  const double here = json["at_1_a_per_us"]["target_v_per_m"];
  EXPECT_GT(here, 0.05);
  const auto hotspot = nlohmann::json::parse(field("--target hotspot --coil figure8-70 --json").output);
  const double there = hotspot["at_1_a_per_us"]["target_v_per_m"];
  EXPECT_NEAR(json["dose"]["output_pct"], 50 * there / here, 1e-6);
  EXPECT_GE(json["best"]["v_per_m_at_1_a_per_us"], json["best"]["planned_v_per_m_at_1_a_per_us"]);
  EXPECT_EQ(json["best"]["poses"], 900);
  EXPECT_GT(json["coil"]["current_arrows"].size(), 20u);
  EXPECT_EQ(json["regions"].size(), 3u);
}

TEST_F(Field, ComparesThePosesOfTwoTargets) {
  const auto run = field("--target deep --coil figure8-70 --against hotspot --json");
  ASSERT_EQ(run.status, 0) << run.errors;
  const auto json = nlohmann::json::parse(run.output);
  const auto hotspot = nlohmann::json::parse(field("--target hotspot --coil figure8-70 --json").output);
  const auto& against = json["against"];
  EXPECT_EQ(against["target"], "hotspot");
  EXPECT_EQ(against["target_v_per_m_at_1_a_per_us"], json["at_1_a_per_us"]["target_v_per_m"]);
  EXPECT_EQ(against["other_at_its_own_v_per_m_at_1_a_per_us"], hotspot["at_1_a_per_us"]["target_v_per_m"]);
  EXPECT_LT(against["change_at_target"], 0) << "its coil stands elsewhere";
  EXPECT_GT(against["maximum_shift_mm"], 10);
  EXPECT_LT(against["correlation"], 0.95);
  EXPECT_GT(json["regions"][0]["cortex_mm2"], json["regions"][1]["cortex_mm2"]);
  const auto text = field("--target deep --coil figure8-70 --against hotspot --best strength");
  EXPECT_THAT(text.output, AllOf(HasSubstr("the pose of 'hotspot' would give: -"),
                                 HasSubstr("against the planned pose: +"),
                                 HasSubstr("mm2 of the brain's hull"), HasSubstr("ml of the brain")));
}

TEST_F(Field, WritesFilesAndComparesThem) {
  for (const char* name : {"E.vtp", "E.msh"}) {
    const auto written = field("--target deep --coil round --didt 50 -o " + at(name));
    ASSERT_EQ(written.status, 0) << written.errors;
    const auto run = field("--target deep --coil round --didt 50 --json --compare " + at(name));
    ASSERT_EQ(run.status, 0) << run.errors;
    const auto json = nlohmann::json::parse(run.output);
    EXPECT_LT(json["comparison"]["relative_error"], 1e-6) << name;
    EXPECT_EQ(json["comparison"]["maximum_shift_mm"], 0) << name;
  }
  EXPECT_EQ(field("--target deep --coil round -q -o " + at("E.nii.gz")).status, 0);
  EXPECT_TRUE(fs::exists(folder_.path() / "E.nii.gz"));
  const auto mode = fs::status(folder_.path() / "E.vtp").permissions() & fs::perms::all;
  EXPECT_EQ(mode, fs::perms::owner_read | fs::perms::owner_write) << "a patient's file";
  EXPECT_EQ(runFacenav("field --case '" + case_.string() + "' --target deep --coil round -q").status, 0);
}

TEST_F(Field, AnImportedFieldIsATierOfItsTarget) {
  FieldMeshLayout layout;
  layout.brain_mm = 42;
  const auto mesh = folder_.path() / "sim.msh";
  const auto fieldOf = [](const Eigen::Vector3d& p) { return Eigen::Vector3d(0, 0.02 * p.z(), 0); };
  std::ofstream(mesh, std::ios::binary) << madeFieldMesh(layout, fieldOf);
  const auto import = [&](const std::string& options) {
    return runFacenav("import '" + case_.string() + "' " + at("sim.msh") + " " + options);
  };
  EXPECT_EQ(import("").status, 2) << "no target";
  EXPECT_EQ(import("--target hotspot --didt 2 --dry-run").status, 0);
  EXPECT_EQ(field("--target hotspot --tier 3").status, 1) << "nothing was kept";
  const auto imported = import("--target hotspot --didt 2 --json");
  ASSERT_EQ(imported.status, 0) << imported.errors;
  EXPECT_NEAR(nlohmann::json::parse(imported.output)["maximum_v_per_m"], 0.02 * 38, 1e-6)
      << "the highest element";
  const auto run = field("--target hotspot --tier 3 --json");
  ASSERT_EQ(run.status, 0) << run.errors;
  const auto json = nlohmann::json::parse(run.output);
  EXPECT_EQ(json["tier"], 3);
  EXPECT_TRUE(json["coil"].is_null());
  EXPECT_EQ(json["rate_a_per_us"], 2);
  EXPECT_NEAR(json["at_rate"]["target_v_per_m"], 0.02 * 40, 0.1);
  EXPECT_EQ(json["regions"].size(), 3u);
  EXPECT_THAT(field("--target hotspot --tier 3").output, HasSubstr("imported     maximum"));
  EXPECT_THAT(field("--target hotspot --coil round").output, HasSubstr("--tier 3 shows it"));
  EXPECT_EQ(field("--target deep --tier 3").status, 1) << "another pose";
  EXPECT_EQ(field("--target hotspot --tier 3 --best strength").status, 2);
  EXPECT_EQ(field("--target hotspot --coil figure8-70 --compare " + at("sim.msh")).status, 0);
}

TEST_F(Field, RefusesInOneLine) {
  const auto expect = [&](const std::string& arguments, int status, const std::string& words) {
    const auto run = field(arguments);
    EXPECT_EQ(run.status, status) << arguments;
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    EXPECT_THAT(run.errors, HasSubstr(words)) << arguments;
  };
  expect("--target none --coil round", 1, "none");
  expect("--target deep --coil figure9", 1, "give figure8-70, round, or a .ccd");
  expect("--target deep --coil round --tier 1", 1, "three shells are not built");
  expect("--target deep --coil round --output 60", 2, "give --didt");
  expect("--target deep --coil round --didt 50 --output 60", 2, "excludes");
  expect("--target deep --coil round -o E.txt", 2, "no name of a field");
  expect("--target deep --coil round --hotspot hotspot", 2, "--threshold");
  expect("--target deep --coil round --compare none.msh", 1, "none.msh");
  expect("--target deep --coil round --against nowhere", 1, "nowhere");
  expect("--coil round", 2, "--target");
  expect("--target deep", 2, "--coil is required");
}

}  // namespace
}  // namespace facenav::testing
