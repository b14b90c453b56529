// The modes against the direct route, and their file.

#include "facenav/efield/cortex_field.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "efield_scene.h"
#include "facenav/core/whole_file.h"
#include "model/boundary_system.h"
#include "support/refusal.h"
#include "support/test_data.h"

namespace facenav::efield::testing {
namespace {

using facenav::testing::refusalOf;
using facenav::testing::TemporaryFolder;

struct Made {
  FieldSolver solver;
  CortexField field;
};

/// Balls of 642 vertices with 500 points 6 to 40 mm deep in their upper part.
const Made& made() {
  static const Made all = [] {
    TaskMonitor monitor;
    FieldSolver solver(balls(3), {}, monitor);
    Draw draw(8);
    Eigen::Matrix3Xd points(3, 500);
    for (int p = 0; p < 500; ++p) {
      Vector3d towards = draw.direction();
      if (towards.z() < -0.2) towards.z() *= -1;
      points.col(p) = (kInnerSkull_mm - 6 - 0.068 * p) * towards;
    }
    CortexField field = makeCortexField(solver, points, monitor, 192);
    return Made{std::move(solver), std::move(field)};
  }();
  return all;
}

TEST(CortexField, AgreesWithTheDirectRoute) {
  Draw draw(9);
  for (int i = 0; i < 3; ++i) {
    const Pose pose = draw.pose(2.0 * i);
    const Eigen::Matrix3Xd fast = fieldAt(made().field, figureEight(), pose).cast<double>();
    const auto direct = made().solver.fieldAt(figureEight(), pose, made().field.points_mm.cast<double>());
    EXPECT_LT(relativeError(fast, direct), 0.006) << i;
    EXPECT_NEAR(fast.colwise().norm().maxCoeff() / direct.colwise().norm().maxCoeff(), 1, 0.01);
  }
  EXPECT_LT(made().field.mode_error, 0.005);
}

TEST(CortexField, IsLinearInTheCoil) {
  const Pose pose = Draw(10).pose();
  CoilDipoles twice = figureEight();
  twice.moments_Am2 *= -2;
  EXPECT_LT(
      relativeError(fieldAt(made().field, twice, pose), -2 * fieldAt(made().field, figureEight(), pose)),
      1e-5);
}

TEST(CortexField, IsTheSameEachTime) {
  TaskMonitor monitor;
  const Eigen::Matrix3Xd few = made().field.points_mm.leftCols(20).cast<double>();
  EXPECT_EQ(makeCortexField(made().solver, few, monitor, 32).shapes,
            makeCortexField(made().solver, few, monitor, 32).shapes);
}

TEST(CortexField, IsTheSameFromASolverThatMayBeUsedUp) {
  TaskMonitor monitor;
  FieldSolver solver(balls(2), {}, monitor);
  const Eigen::Matrix3Xd few = 0.9 * made().field.points_mm.leftCols(20).cast<double>();
  const CortexField kept = makeCortexField(solver, few, monitor, 32);
  EXPECT_EQ(makeCortexField(static_cast<FieldSolver&&>(solver), few, monitor, 32).shapes, kept.shapes);
  EXPECT_EQ(solver.system().lu.size(), 0) << "its memory is free";
}

TEST(CortexField, RefusesACortexWithoutPoints) {
  TaskMonitor monitor;
  EXPECT_NE(refusalOf([&] { makeCortexField(made().solver, Eigen::Matrix3Xd(3, 0), monitor); }), "");
}

TEST(CortexFieldFile, GivesBackWhatWasWritten) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "field.bin";
  writeCortexField(made().field, "head 1", path);
  const CortexField read = readCortexField(path, "head 1");
  EXPECT_EQ(read.points_mm, made().field.points_mm);
  EXPECT_EQ(read.is_moved, made().field.is_moved);
  EXPECT_EQ(read.mode_error, made().field.mode_error);
  const Pose pose = Draw(11).pose();
  EXPECT_EQ(fieldAt(read, figureEight(), pose), fieldAt(made().field, figureEight(), pose));
  struct stat status {};
  ASSERT_EQ(::stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);
}

TEST(CortexFieldFile, RefusesAnotherHeadAndDamage) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "field.bin";
  writeCortexField(made().field, "head 1", path);
  EXPECT_NE(refusalOf([&] { readCortexField(path, "head 2"); }).find("computed for another head model"),
            std::string::npos);
  const std::string whole = readWholeFile(path);
  for (const std::string& damaged :
       {std::string("x"), whole.substr(0, whole.size() / 2), whole + "x", std::string(400, '\xff')}) {
    writeWholeFile(path, damaged);
    EXPECT_NE(refusalOf([&] { readCortexField(path, "head 1"); }).find("damaged"), std::string::npos);
  }
  std::string changed = whole;
  changed[changed.size() / 2] ^= 1;
  writeWholeFile(path, changed);
  EXPECT_NE(refusalOf([&] { readCortexField(path, "head 1"); }).find("damaged"), std::string::npos);
}

}  // namespace
}  // namespace facenav::efield::testing
