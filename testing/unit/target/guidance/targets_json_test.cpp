#include <gtest/gtest.h>

#include <limits>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "made_targets.h"
#include "support/matchers.h"
#include "support/test_data.h"

namespace facenav::guidance {
namespace {
using namespace guidance::testing;
using facenav::testing::PoseNear;
using facenav::testing::TemporaryFolder;

std::string oneTarget(const std::string& matrix, const std::string& more = "") {
  return R"({"targets": [{"name": "a", "mri_T_target": )" + matrix +
         R"(, "cortex_point_mm": [1, 2, 3], "scalp_point_mm": [4, 5, 6])" + more + "}]}";
}
const std::string kIdentity = "[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]";

std::string faultOf(const std::string& content) {
  const TemporaryFolder folder;
  writeWholeFile(folder.path() / "targets.json", content);
  try {
    const auto damaged = readTargets(folder.path() / "targets.json").damaged;
    return damaged.empty() ? "" : damaged.front();
  } catch (const Error& fault) {
    return fault.what();
  }
  return "";
}

TEST(TargetsJson, RoundTripKeepsEveryDigit) {
  const TemporaryFolder folder;
  TreatmentPlan plan;
  plan.targets = {vertexTarget(), vertexTarget()};
  plan.targets[1].name = "M1 hand L, über \"Mitte\"";
  plan.targets[1].note = "60 % of threshold";
  plan.targets[1].mri_T_target = poseFrom<frames::Target>({1.0 / 3, -2.0 / 7, 99}, {1, 2, -3}, {0.3, 1, 0});
  writeTargets(plan, folder.path() / "targets.json");
  const TreatmentPlan read = readTargets(folder.path() / "targets.json");
  ASSERT_EQ(read.targets.size(), 2u);
  EXPECT_THAT(read.find(plan.targets[1].name).mri_T_target,
              PoseNear(plan.targets[1].mri_T_target, 1e-9, 1e-12));
  EXPECT_EQ(read.targets[1].note, plan.targets[1].note);
  EXPECT_EQ(read.targets[0].cortex_point.mm, plan.targets[0].cortex_point.mm);
  EXPECT_EQ(read.targets[0].scalp_point.mm, plan.targets[0].scalp_point.mm);
}

TEST(TargetsJson, KeepsLockDoseGridAndEveryChange) {
  const TemporaryFolder folder;
  TreatmentPlan plan;
  plan.targets = {vertexTarget(), vertexTarget()};
  Target& target = plan.targets[0];
  target.lift_mm = 1.25;
  target.is_locked = true;
  target.dose = Dose{};
  target.dose->pulses = 3000;
  target.dose->threshold_pct = 80.5;
  target.grid = GridSpec{3, 5, 7.5, GridOn::cortex};
  target.changes = {{"2026-11-23T14:05:09.123Z", "AB", "planned"}, {"2026-11-23T14:06:09.123Z", "", "moved"}};
  plan.targets[1].name = "vertex r1 c2";
  plan.targets[1].grid_place = GridPlace{"vertex", 1, 2, true};
  const auto path = folder.path() / "targets.json";
  writeTargets(plan, path);
  const TreatmentPlan read = readTargets(path);
  EXPECT_EQ(read.targets[0].lift_mm, 1.25);
  EXPECT_TRUE(read.targets[0].is_locked);
  EXPECT_EQ(*read.targets[0].dose, *target.dose);
  EXPECT_EQ(*read.targets[0].grid, *target.grid);
  ASSERT_EQ(read.targets[0].changes.size(), 2u);
  EXPECT_EQ(read.targets[0].changes[0].by, "AB");
  EXPECT_EQ(read.targets[0].changes[1].what, "moved");
  EXPECT_EQ(read.targets[1].grid_place->seed, "vertex");
  EXPECT_TRUE(read.targets[1].grid_place->is_edited);
  target.is_locked = false;
  target.dose.reset();
  writeTargets(plan, path);  // over the first: removed entries vanish
  EXPECT_FALSE(readTargets(path).targets[0].is_locked);
  EXPECT_FALSE(readTargets(path).targets[0].dose);
}

TEST(TargetsJson, MatrixIsRowMajorInMillimetres) {
  const TemporaryFolder folder;
  writeWholeFile(folder.path() / "t.json", oneTarget("[0,-1,0,10, 1,0,0,20, 0,0,1,30, 0,0,0,1]"));
  const auto pose = readTargets(folder.path() / "t.json").targets[0].mri_T_target;
  EXPECT_THAT((pose * Point<frames::Target>(1, 0, 0)).mm,
              facenav::testing::EigenNear(Eigen::Vector3d(10, 21, 30), 1e-12));
}

TEST(TargetsJson, RefusesMirroredAndSkewedMatrices) {
  EXPECT_NE(faultOf(oneTarget("[-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]")).find("mirrored"), std::string::npos);
  EXPECT_NE(faultOf(oneTarget("[2,0,0,0, 0,2,0,0, 0,0,2,0, 0,0,0,1]")).find("not rigid"), std::string::npos);
  // Column-major: the translation is in the last row.
  EXPECT_NE(faultOf(oneTarget("[1,0,0,0, 0,1,0,0, 0,0,1,0, 5,6,7,1]")).find("last row"), std::string::npos);
}

TEST(TargetsJson, NamesFileAndKeyOfAFault) {
  const struct {
    std::string content, key;
  } faults[] = {
      {R"({})", "targets"},
      {R"({"targets": {}})", "targets"},
      {R"({"targets": [{}]})", "targets[0].name"},
      {R"({"targets": [{"name": 7}]})", "targets[0].name"},
      {R"({"targets": [{"name": "a"}]})", "targets[0].mri_T_target"},
      {oneTarget("[1, 2, 3]"), "mri_T_target"},
      {oneTarget(R"(["1",0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1])"), "mri_T_target[0]"},
      {oneTarget(kIdentity, R"(, "note": 5)"), "note"},
      {"{\"targets\": [", "JSON"},
      {"[]", "object"},
  };
  for (const auto& fault : faults) {
    const std::string message = faultOf(fault.content);
    EXPECT_NE(message.find("targets.json"), std::string::npos) << message;
    EXPECT_NE(message.find(fault.key), std::string::npos) << message;
  }
  EXPECT_EQ(faultOf(oneTarget(kIdentity, R"(, "colour": "red")")), "");
}

TEST(TargetsJson, RefusesANameGivenTwice) {
  const std::string target = R"({"name": "a", "mri_T_target": )" + kIdentity +
                             R"(, "cortex_point_mm": [1, 2, 3], "scalp_point_mm": [4, 5, 6]})";
  EXPECT_NE(faultOf(R"({"targets": [)" + target + "," + target + "]}").find("same name"), std::string::npos);
}

std::string named(const std::string& name, const std::string& matrix) {
  return "{\"name\": \"" + name + "\", \"mri_T_target\": " + matrix +
         R"(, "cortex_point_mm": [1, 2, 3], "scalp_point_mm": [4, 5, 6]})";
}

TEST(TargetsJson, ADamagedTargetIsLeftOutAndSaidAndTheOthersStay) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "targets.json";
  const std::string good = named("a", kIdentity), last = named("c", kIdentity);
  const std::string rest = ",0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]";
  for (const std::string& bad :
       {named("b", "[null" + rest), named("b", "[NaN" + rest), named("b", "[Infinity" + rest),
        named("b", "[1e999" + rest), named("b", "[1,0,0,1e30, 0,1,0,0, 0,0,1,0, 0,0,0,1]"),
        named("b", "[1,0,0,5000, 0,1,0,0, 0,0,1,0, 0,0,0,1]"), named("b\\u001b[31m", kIdentity),
        std::string("7"), named("a", kIdentity)}) {
    writeWholeFile(path, R"({"targets": [)" + good + "," + bad + "," + last + "]}");
    const auto plan = readTargets(path);
    ASSERT_EQ(plan.targets.size(), 2u) << bad;
    EXPECT_EQ(plan.targets[1].name, "c") << bad;
    EXPECT_FALSE(plan.damaged.empty()) << bad;
  }
}

TEST(TargetsJson, AFileCutShortKeepsItsWholeTargets) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "targets.json";
  const std::string whole = R"({"targets": [)" + named("a", kIdentity) + "," + named("b", kIdentity);
  writeWholeFile(path, whole.substr(0, whole.size() - 20));
  const auto plan = readTargets(path);
  ASSERT_EQ(plan.targets.size(), 1u);
  EXPECT_EQ(plan.targets[0].name, "a");
  EXPECT_EQ(plan.damaged.size(), 1u);
}

TEST(TargetsJson, WhatWasDamagedIsKeptBesideTheFileThatReplacesIt) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "targets.json";
  const std::string content =
      R"({"targets": [)" + named("a", kIdentity) + R"(, {"name": "b", "note": "C3"}]})";
  writeWholeFile(path, content);
  writeTargets(readTargets(path), path);
  EXPECT_TRUE(readTargets(path).damaged.empty());
  EXPECT_EQ(readWholeFile(folder.path() / "targets_damaged.json"), content);
}

TEST(TargetsJson, TheWriterRefusesATargetThatCannotBeRead) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "targets.json";
  TreatmentPlan plan;
  plan.targets = {vertexTarget()};
  writeTargets(plan, path);
  const std::string before = readWholeFile(path);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Target> unsound(7, vertexTarget());
  unsound[0].cortex_point.mm.x() = nan;
  unsound[1].scalp_point.mm.z() = 1e30;
  unsound[2].mri_T_target = poseFrom<frames::Target>({nan, 0, 99}, {0, 0, -1}, {0, 1, 0});
  unsound[3].name = "two\nlines";
  unsound[4].name = std::string(500, 'x');
  unsound[5].dose = Dose{};
  unsound[5].dose->pulses = 10;
  unsound[5].dose->frequency_hz = nan;
  unsound[6].lift_mm = nan;
  for (const auto& target : unsound) {
    plan.targets = {target};
    EXPECT_THROW(writeTargets(plan, path), Error) << target.name;
  }
  EXPECT_EQ(readWholeFile(path), before);
}

TEST(TargetsJson, KeepsKeysItDoesNotKnow) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "targets.json";
  writeWholeFile(path, R"({"made_by": "other", "targets": [{"name": "a", "colour": "red", "mri_T_target": )" +
                           kIdentity + R"(, "cortex_point_mm": [1, 2, 3], "scalp_point_mm": [4, 5, 6]}]})");
  TreatmentPlan plan = readTargets(path);
  plan.targets.push_back(vertexTarget());
  writeTargets(plan, path);
  const std::string content = readWholeFile(path);
  EXPECT_NE(content.find("\"colour\": \"red\""), std::string::npos);
  EXPECT_NE(content.find("\"made_by\": \"other\""), std::string::npos);
  EXPECT_EQ(readTargets(path).targets.size(), 2u);
}

TEST(TargetsJson, UnknownTargetListsTheKnownOnes) {
  TreatmentPlan plan;
  plan.targets = {vertexTarget()};
  try {
    plan.find("M1");
    FAIL();
  } catch (const Error& fault) {
    EXPECT_NE(std::string(fault.what()).find("'vertex'"), std::string::npos);
  }
}

}  // namespace
}  // namespace facenav::guidance
