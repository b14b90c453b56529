#include "facenav/guidance/coil_plate.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/guidance/handle.h"
#include "made_targets.h"
#include "support/matchers.h"
#include "support/test_data.h"

namespace facenav::guidance {
namespace {
using namespace guidance::testing;
using facenav::testing::EigenNear;
using ::testing::HasSubstr;

constexpr double kPlateBall_mm = 90;

surface::ScalpSurface plateBall(int rows = 180) {
  surface::ScalpSurface scalp;
  scalp.mesh = sphere(Eigen::Vector3d::Zero(), kPlateBall_mm, rows);
  return scalp;
}

/// Ball with a bump, or a dent for a negative height, of 8 mm sigma in the direction `at`.
surface::ScalpSurface ballWith(const Eigen::Vector3d& at, double height_mm, double sigma_mm = 8) {
  surface::ScalpSurface scalp = plateBall();
  for (auto& v : scalp.mesh.vertices_mm) {
    const double away_mm = (v - kPlateBall_mm * at.normalized()).norm();
    v *= 1 + height_mm / kPlateBall_mm * std::exp(-0.5 * away_mm * away_mm / (sigma_mm * sigma_mm));
  }
  return scalp;
}

Target plannedOver(const surface::ScalpSurface& scalp, const Eigen::Vector3d& direction, double gap_mm = 0) {
  return planTarget("spot", scalp, Point<Mri>(70 * direction.normalized()), rad(30), gap_mm);
}

/// Greatest height of skin above the plate within its outline, computed independently: a fine lattice of
/// points on every triangle.
double lies_through_mm(const Target& target, const surface::ScalpSurface& scalp, const CoilPlate& plate) {
  const auto coil_T_mri = target.mri_T_target.inverse();
  const auto inside = [&](double x, double y) {  // winding of the outline around the point
    double turned = 0;
    for (std::size_t i = 0; i < plate.outline_mm.size(); ++i) {
      const Eigen::Vector2d a = plate.outline_mm[i] - Eigen::Vector2d(x, y);
      const Eigen::Vector2d b = plate.outline_mm[(i + 1) % plate.outline_mm.size()] - Eigen::Vector2d(x, y);
      turned += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    }
    return std::abs(turned) > M_PI;
  };
  double through_mm = -1e300;
  for (const auto& t : scalp.mesh.triangles)
    for (int i = 0; i <= 2; ++i)
      for (int j = 0; i + j <= 2; ++j) {
        const Eigen::Vector3d p = 0.5 * (i * scalp.mesh.vertices_mm[std::size_t(t[0])] +
                                         j * scalp.mesh.vertices_mm[std::size_t(t[1])] +
                                         (2 - i - j) * scalp.mesh.vertices_mm[std::size_t(t[2])]);
        const Eigen::Vector3d q = (coil_T_mri * Point<Mri>(p)).mm;
        if (q.z() < 40 && inside(q.x(), q.y())) through_mm = std::max(through_mm, -q.z());
      }
  return through_mm;
}

TEST(CoilPlate, OnABallItTouchesUnderItsCentreAndStandsUpright) {
  const auto scalp = plateBall();
  for (const Eigen::Vector3d& place :
       {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(-1, 0.2, 1), Eigen::Vector3d(0.1, 1, 0.1)}) {
    const Target target = restOnHead(plannedOver(scalp, place), scalp, figureOfEight());
    EXPECT_THAT(target.mri_T_target.rotation().col(2), EigenNear(-place.normalized(), 0.005));
    EXPECT_NEAR(target.mri_T_target.translation_mm().norm(), kPlateBall_mm, 0.05);
    EXPECT_NEAR(lies_through_mm(target, scalp, figureOfEight()), 0.0, 0.05);
    EXPECT_TRUE(contactOf(target, scalp, figureOfEight()).isTangent());
  }
}

TEST(CoilPlate, KeepsAimHandleGapNameAndNote) {
  const auto scalp = ballWith({-1, 0.3, 1}, 3);
  Target planned = plannedOver(scalp, {-1, 0.2, 1}, 4.0);
  planned.note = "hotspot";
  const Target target = restOnHead(planned, scalp, figureOfEight());
  EXPECT_NEAR(hairGap_mm(target), 4.0, 1e-9);
  EXPECT_NEAR(handleAngle(target, scalp).angle_rad, rad(30), 1e-6);
  EXPECT_EQ(target.name, "spot");
  EXPECT_EQ(target.note, "hotspot");
  const Eigen::Vector3d aim = (target.mri_T_target.inverse() * target.cortex_point).mm;
  EXPECT_NEAR(aim.head<2>().norm(), 0.0, 1e-9) << "the axis passes through the cortex point";
  EXPECT_NEAR(lies_through_mm(target, scalp, figureOfEight()), -4.0, 0.05) << "hair keeps it off";
}

TEST(CoilPlate, SpansADentUnderItsCentreWithoutTilting) {
  // A dent of 3 mm in a ball of 90 mm: the plate rests on its rim. The sphere alone falls by r^2 / 180, the
  // dent fills by 3 exp(-r^2 / 200 mm^2): the rim is where their sum is highest.
  const auto scalp = ballWith({0, 0, 1}, -3, 10);
  double rim_mm = 0;
  for (double r = 0; r < 40; r += 0.01)
    rim_mm = std::max(rim_mm, std::sqrt(kPlateBall_mm * kPlateBall_mm - r * r) - 3 * std::exp(-r * r / 200));
  const Target target = restOnHead(plannedOver(scalp, {0, 0, 1}), scalp, figureOfEight());
  EXPECT_NEAR(target.mri_T_target.translation_mm().z(), rim_mm, 0.1);
  EXPECT_NEAR(target.lift_mm, rim_mm - 87, 0.1);
  EXPECT_THAT(target.mri_T_target.rotation().col(2), EigenNear(Eigen::Vector3d(0, 0, -1), 0.02));
  EXPECT_NEAR(hairGap_mm(target), 0.0, 1e-9) << "the lift is no hair";
  EXPECT_NEAR(centreGap_mm(target), target.lift_mm, 1e-9);
}

TEST(CoilPlate, TiltsOverAnEarUnderOneWingAndSaysSo) {
  // An ear of 22 mm, 45 mm beside the aim, under the coil's left wing.
  const auto scalp = ballWith({std::sin(0.5), 0, std::cos(0.5)}, 22, 6);
  const Target flat = planTarget("spot", scalp, Point<Mri>(0, 0, 70), 0.0);
  EXPECT_GT(lies_through_mm(flat, scalp, figureOfEight()), 1.0)
      << "a tangent coil would pass through the ear";
  const Target target = restOnHead(flat, scalp, figureOfEight());
  EXPECT_NEAR(lies_through_mm(target, scalp, figureOfEight()), 0.0, 0.05);
  const PlateContact contact = contactOf(target, scalp, figureOfEight());
  EXPECT_FALSE(contact.isTangent());
  // In the plane through ear tip and centre, the tangent from the tip (112 mm from the centre, 0.5 rad beside
  // the top) to the ball leans by acos(90 / 112) - 0.5 rad = 7.8 degrees.
  EXPECT_NEAR(std::acos(target.mri_T_target.rotation()(2, 2) * -1), rad(7.8), rad(1));
  EXPECT_GE(contact.touching.size(), 1u);
  EXPECT_NEAR(contact.through_mm, 0.0, 1e-6);
}

TEST(CoilPlate, IsTakenFromTheCoilFile) {
  const facenav::testing::TemporaryFolder folder;
  const auto write = [&](const std::string& outline) {
    writeWholeFile(folder.path() / "coil.json", R"({"name": "c")" + outline + "}");
    return folder.path() / "coil.json";
  };
  EXPECT_EQ(readPlate(write("")).outline_mm.size(), figureOfEight().outline_mm.size());
  const CoilPlate plate =
      readPlate(write(R"(, "contact_outline_mm": [[-30, -20], [30, -20], [30, 20], [-30, 20]])"));
  EXPECT_EQ(plate.outline_mm.size(), 4u);
  EXPECT_THAT(plate.outline_mm[2], EigenNear(Eigen::Vector2d(30, 20), 0));
  const auto refusal = [&](const std::string& outline) -> std::string {
    try {
      readPlate(write(R"(, "contact_outline_mm": )" + outline));
    } catch (const Error& error) {
      return error.what();
    }
    return "read";
  };
  EXPECT_THAT(refusal("[[1, 2], [3, 4]]"), HasSubstr("three corners"));
  EXPECT_THAT(refusal("[[10, 0], [20, 0], [20, 10]]"), HasSubstr("centre"));
  EXPECT_THAT(refusal("[[10], [20, 0], [20, 10]]"), HasSubstr("contact_outline_mm[0]"));
}

TEST(CoilPlate, ASmallPlateFitsWhereALargeOneTilts) {
  const auto scalp = ballWith({std::sin(0.5), 0, std::cos(0.5)}, 22, 6);
  CoilPlate small;
  small.outline_mm = {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}};
  const Target flat = planTarget("spot", scalp, Point<Mri>(0, 0, 70), 0.0);
  EXPECT_TRUE(contactOf(restOnHead(flat, scalp, small), scalp, small).isTangent());
}

TEST(CoilPlate, ATurnKeepsItsAxisUnlessAnEarComesUnderAWing) {
  const auto scalp = ballWith({std::sin(0.5), 0, std::cos(0.5)}, 22, 6);
  // The handle lies along the ear's direction: both wings are clear of it.
  Target along = planTarget("spot", scalp, Point<Mri>(0, 0, 70), 0.0);
  along = restOnHead(withHandleAngle(along, scalp, rad(90)), scalp, figureOfEight());
  const Target little = settleOnHead(withHandleAngle(along, scalp, rad(95)), scalp, figureOfEight());
  EXPECT_THAT(little.mri_T_target.rotation().col(2), EigenNear(along.mri_T_target.rotation().col(2), 1e-9));
  const Target across = settleOnHead(withHandleAngle(along, scalp, 0.0), scalp, figureOfEight());
  EXPECT_GT(std::acos(-across.mri_T_target.rotation()(2, 2)), rad(5)) << "it had to tilt";
  EXPECT_NEAR(lies_through_mm(across, scalp, figureOfEight()), 0.0, 0.05);
}

/// Ellipsoid as long as a head, its skin as rough as an MRI's: ripples of 0.2 mm, 5 to 7 mm long.
surface::ScalpSurface roughHead() {
  surface::ScalpSurface scalp;
  scalp.mesh = sphere(Eigen::Vector3d::Zero(), 1.0, 120);
  for (auto& v : scalp.mesh.vertices_mm) {
    const Eigen::Vector3d out = v;
    v = v.cwiseProduct(Eigen::Vector3d(74, 96, 86));
    v += 0.2 * (std::sin(1.1 * v.x()) + std::sin(1.3 * v.y() + 1) + std::sin(0.9 * v.z() + 2)) / 3 * out;
  }
  return scalp;
}

TEST(CoilPlate, TwoNudgesOnRoughSkinTurnTheHandleOnlyAsTheHeadCurves) {
  const auto scalp = roughHead();
  const auto plate = figureOfEight();
  for (const Eigen::Vector3d& direction : {Eigen::Vector3d(-1, 0.1, 1), Eigen::Vector3d(-0.7, 0.7, 0.6),
                                           Eigen::Vector3d(1, -0.3, 0.7), Eigen::Vector3d(0.05, 0, 1)})
    for (const double x_mm : {1.0, -1.0}) {
      const Point<Mri> cortex(0.78 * direction.normalized().cwiseProduct(Eigen::Vector3d(74, 96, 86)));
      const Target start = restOnHead(planTarget("spot", scalp, cortex, rad(45), 3.0), scalp, plate);
      Target moved = start;
      for (int i = 0; i < 2; ++i) moved = movedOnHead(moved, scalp, plate, x_mm, 0);
      EXPECT_NEAR((handleAngle(moved, scalp).angle_rad - handleAngle(start, scalp).angle_rad) * kDegPerRad,
                  0.0, 2.5)
          << direction.transpose();
      EXPECT_NEAR(hairGap_mm(moved), 3.0, 1e-6);
      for (int i = 0; i < 2; ++i) moved = movedOnHead(moved, scalp, plate, -x_mm, 0);
      EXPECT_GT(moved.mri_T_target.rotation().col(1).dot(start.mri_T_target.rotation().col(1)),
                std::cos(rad(1)))
          << "back again, " << direction.transpose();
    }
}

TEST(CoilPlate, ANudgeMovesThePlateAsFarAsItSaysWhereverItStands) {
  const auto scalp = plateBall();
  for (const double beside_mm : {0.0, 12.0}) {
    Target start = restOnHead(plannedOver(scalp, {-1, 0.2, 1}), scalp, figureOfEight());
    start.cortex_point.mm += beside_mm * start.mri_T_target.rotation().col(0);
    for (const Eigen::Vector2d& way_mm :
         {Eigen::Vector2d(1, 0), Eigen::Vector2d(0, -1), Eigen::Vector2d(-5, 0), Eigen::Vector2d(6, 8)}) {
      const Target moved = movedOnHead(start, scalp, figureOfEight(), way_mm.x(), way_mm.y());
      const Eigen::Vector3d step =
          start.mri_T_target.rotation().transpose() *
          (moved.mri_T_target.translation_mm() - start.mri_T_target.translation_mm());
      EXPECT_THAT(Eigen::Vector2d(step.head<2>()), EigenNear(way_mm, 0.03));
      EXPECT_NEAR(moved.mri_T_target.translation_mm().norm(), kPlateBall_mm, 0.05) << "on the skin";
      const Eigen::Vector3d under = (start.mri_T_target.inverse() * start.cortex_point).mm;
      const Eigen::Vector3d under_then = (moved.mri_T_target.inverse() * moved.cortex_point).mm;
      EXPECT_THAT(under_then, EigenNear(under, 0.05)) << "the target moves with its plate";
    }
  }
}

TEST(CoilPlate, RefusesAnAxisThatMeetsNoSkin) {
  Target target = plannedOver(plateBall(), {0, 0, 1});
  EXPECT_THROW(restOnHead(target, surface::ScalpSurface{}, figureOfEight()), Error);
  surface::ScalpSurface half = plateBall();
  auto& triangles = half.mesh.triangles;  // the upper half is missing
  triangles.erase(
      std::remove_if(triangles.begin(), triangles.end(),
                     [&](const auto& t) { return half.mesh.vertices_mm[std::size_t(t[0])].z() > 0; }),
      triangles.end());
  EXPECT_THROW(restOnHead(target, half, figureOfEight()), Error);
}

}  // namespace
}  // namespace facenav::guidance
