// The measures of a real head do not depend on its pose in the scanner or on mirroring, and they follow its
// scale. Without a face there are no measures.

#include "facenav/surface/face_measures.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <functional>

#include "facenav/anatomy/nose.h"
#include "facenav/segmentation/segmenter.h"
#include "facenav/surface/navigation_check.h"
#include "facenav/volume/nifti.h"
#include "facenav/volume/regrid.h"
#include "support/test_data.h"

namespace facenav::surface {
namespace {

constexpr double kVoxel_mm = 1.5;

const ScalpSurface& measuredScalp() {
  static const ScalpSurface scalp = [] {
    const auto full = volume::readNifti(facenav::testing::virtualPatientMri()).volume;
    const auto coarse = volume::resample(full, volume::isotropicGrid(full.grid, kVoxel_mm));
    TaskMonitor monitor;
    return extractScalp(coarse, segmentation::makeHeadSegmenter()->segment(coarse, monitor).mask, monitor);
  }();
  return scalp;
}

ScalpSurface transformed(ScalpSurface scalp, const Eigen::Matrix3d& m) {
  const bool is_mirrored = m.determinant() < 0;
  for (auto& v : scalp.mesh.vertices_mm) v = m * v;
  for (auto& n : scalp.mesh.normals) n = (m * n).normalized();
  if (is_mirrored)
    for (auto& t : scalp.mesh.triangles) std::swap(t[1], t[2]);
  for (auto& [point, out] : scalp.field_of_view)
    point = Point<Mri>(m * point.mm), out = Direction<Mri>(m * out.v);
  return scalp;
}

std::vector<FaceMeasure> measuresOf(const ScalpSurface& scalp) {
  return measureFace(findFaceLandmarks(scalp), kVoxel_mm);
}

std::string sidesSwapped(std::string name) {
  for (const auto& [from, to] :
       {std::pair<std::string, std::string>{"right", "LEFT"}, {"left", "right"}, {"LEFT", "left"}})
    if (const auto at = name.find(from); at != std::string::npos) name.replace(at, from.size(), to);
  return name;
}

/// Expects every measure of `expected` times `scale`, within its given uncertainty.
void expectSame(
    const std::vector<FaceMeasure>& actual, const std::vector<FaceMeasure>& expected, double scale,
    const std::function<std::string(std::string)>& renamed = [](std::string name) { return name; }) {
  for (const FaceMeasure& e : expected) {
    const auto a = std::find_if(actual.begin(), actual.end(),
                                [&](const FaceMeasure& m) { return m.name == renamed(e.name); });
    ASSERT_NE(a, actual.end()) << e.name;
    EXPECT_NEAR(a->value_mm, scale * e.value_mm, e.uncertainty_mm) << e.name;
  }
}

// One test, because ctest would extract the scalp again for each.
TEST(FaceMeasures, OfAnAdultAreUsualAndFollowPoseScaleAndMirror) {
  FACENAV_NEEDS(facenav::testing::virtualPatientMri());
  const ScalpSurface& scalp = measuredScalp();
  const auto straight = measuresOf(scalp);
  EXPECT_GE(straight.size(), 10u);
  // After resampling, the nose cut by the scan's edge is just a short nose: nothing marks it as cut.
  for (const auto& measure : straight) {
    if (measure.to == "pronasale") continue;
    EXPECT_TRUE(measure.isUsual()) << measure.name << " " << measure.value_mm;
  }
  for (const Eigen::Vector3d& turn_deg :
       {Eigen::Vector3d(15, 0, 0), Eigen::Vector3d(-15, 0, 0), Eigen::Vector3d(0, 12, 0),
        Eigen::Vector3d(0, 0, 15), Eigen::Vector3d(10, -8, -12)}) {
    SCOPED_TRACE(turn_deg.transpose());
    const Eigen::Vector3d a = turn_deg * M_PI / 180;
    const Eigen::Matrix3d turn = (Eigen::AngleAxisd(a.x(), Eigen::Vector3d::UnitX()) *
                                  Eigen::AngleAxisd(a.y(), Eigen::Vector3d::UnitY()) *
                                  Eigen::AngleAxisd(a.z(), Eigen::Vector3d::UnitZ()))
                                     .toRotationMatrix();
    expectSame(measuresOf(transformed(scalp, turn)), straight, 1.0);
  }
  expectSame(measuresOf(transformed(scalp, 1.06 * Eigen::Matrix3d::Identity())), straight, 1.06);
  expectSame(measuresOf(transformed(scalp, Eigen::DiagonalMatrix<double, 3>(-1, 1, 1))), straight, 1.0,
             sidesSwapped);
  const auto giant = measuresOf(transformed(scalp, 1.25 * Eigen::Matrix3d::Identity()));
  EXPECT_TRUE(std::any_of(giant.begin(), giant.end(), [](const auto& m) { return !m.isUsual(); }));
}

TEST(FaceLandmarks, BothSearchesFindOneNose) {
  const ScalpSurface& scalp = measuredScalp();
  const FaceLandmarks landmarks = findFaceLandmarks(scalp);
  ASSERT_TRUE(landmarks.find("pronasale") && landmarks.find("nasion"));
  EXPECT_LT((anatomy::findNoseTip(scalp.mesh.vertices_mm) - landmarks.find("pronasale")->point.mm).norm(),
            10.0)
      << "good to a centimetre";
}

TEST(FaceMeasures, LowerBoundIsOnlyEverTooLarge) {
  FaceMeasure measure{"nose", "a", "b", 30, 3, UsualRange{37, 58}, true};
  EXPECT_TRUE(measure.isUsual());
  measure.is_lower_bound = false;
  EXPECT_FALSE(measure.isUsual());
  measure.value_mm = 70;
  measure.is_lower_bound = true;
  EXPECT_FALSE(measure.isUsual());
}

TEST(FaceMeasures, BallHasNone) {
  ScalpSurface ball;  // an octahedron, refined
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-80.0, 80.0})
      ball.mesh.vertices_mm.push_back(sign * Eigen::Vector3d::Unit(axis)),
          ball.mesh.normals.push_back(sign * Eigen::Vector3d::Unit(axis) / 80);
  for (const int x : {0, 1})
    for (const int y : {2, 3})
      for (const int z : {4, 5})
        ball.mesh.triangles.push_back((x + y + z) % 2 ? Eigen::Vector3i(x, y, z) : Eigen::Vector3i(x, z, y));
  EXPECT_TRUE(findFaceLandmarks(ball).points.empty());
  EXPECT_TRUE(findFaceLandmarks({}).points.empty());
}

}  // namespace
}  // namespace facenav::surface
