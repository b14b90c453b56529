// The Python package (resources/python): its own tests on a case that FaceNav made.

#include <gtest/gtest.h>

#include "support/ball_case.h"
#include "support/command_line.h"
#include "support/made_session.h"

namespace facenav::testing {
namespace {

guidance::Target pythonTarget(const std::string& name, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d out = direction.normalized();
  guidance::Target target;
  target.name = name;
  target.mri_T_target = {Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), -out), 92.0 * out};
  target.cortex_point = Point<Mri>(60.0 * out);
  target.scalp_point = Point<Mri>(90.0 * out);
  return target;
}

TEST(PythonPackage, ReadsAndWritesWhatTheProgramDoes) {
  if (std::system("/usr/bin/python3 -c 'import numpy, nibabel' 2>/dev/null") != 0)
    GTEST_SKIP() << "python3-numpy and python3-nibabel are not installed";
  const TemporaryFolder folder;
  const auto store = casefile::CaseStore::create(folder.path() / "case", ballWithBrain(), {}, false);
  guidance::TreatmentPlan plan;
  plan.targets = {pythonTarget("M1 hand L", {-0.5, 0.1, 0.8}), pythonTarget("左 DLPFC", {-0.5, 0.6, 0.6})};
  plan.targets[1].note = "two\nlines";
  store.setTargets(plan);
  MadeSession made;
  made.has_meps = true;
  writeMadeSession(store.folder(), store.targets().targets.front(), made);
  const std::string package = std::string(FACENAV_SOURCE_DIR) + "/resources/python";
  const auto result =
      runProgram("/usr/bin/env", "PYTHONDONTWRITEBYTECODE=1 FACENAV_CLI='" FACENAV_CLI "' FACENAV_CASE='" +
                                     store.folder().string() + "' PYTHONPATH='" + package +
                                     "' /usr/bin/python3 '" + package + "/tests/test_facenav.py'");
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(result.errors.find("skipped"), std::string::npos) << result.errors;
  const auto example = runProgram("/usr/bin/env", "PYTHONDONTWRITEBYTECODE=1 PYTHONPATH='" + package +
                                                      "' /usr/bin/python3 '" + package + "/example.py' '" +
                                                      store.folder().string() + "' --add 'from Python'");
  EXPECT_EQ(example.status, 0) << example.errors;
  EXPECT_NE(example.output.find("40 pulses"), std::string::npos) << example.output;
  const auto added = store.targets();
  EXPECT_TRUE(added.damaged.empty());
  EXPECT_EQ(added.targets.size(), 3u);
  EXPECT_EQ(added.find("左 DLPFC").note, "two\nlines");
  const auto& target = added.find("from Python");
  EXPECT_NEAR(target.mri_T_target.rotation().determinant(), 1, 1e-9);
  const Eigen::Vector3d inward = (target.cortex_point.mm - target.mri_T_target.translation_mm()).normalized();
  EXPECT_GT(target.mri_T_target.rotation().col(2).dot(inward), 0.999);
}

}  // namespace
}  // namespace facenav::testing
