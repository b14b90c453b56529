#include "facenav/efield/built_in_coils.h"

#include <gtest/gtest.h>

#include <cmath>

#include "facenav/core/error.h"
#include "facenav/efield/coil_source.h"
#include "facenav/efield/current_arrows.h"
#include "facenav/efield/primary_field.h"
#include "facenav/efield/thinned_coil.h"

namespace facenav::efield {
namespace {

using CoilPose = RigidTransform<Mri, frames::Coil>;

/// The windings as very many dipoles: discs of every turn, in layers over the wire's height.
CoilDipoles manyDipoles(const std::vector<Spiral>& spirals) {
  constexpr double kStep_mm = 1;
  constexpr int kLayers = 5;
  std::vector<Eigen::Vector3d> places, moments;
  for (const auto& spiral : spirals) {
    const double outer_mm = spiral.radius_mm(spiral.turns - 1) + spiral.width_mm / 2;
    for (double r_mm = kStep_mm / 2; r_mm < outer_mm; r_mm += kStep_mm) {
      double turns = 0;  // turns that surround this radius
      for (int turn = 0; turn < spiral.turns; ++turn)
        turns += std::clamp((spiral.radius_mm(turn) - r_mm) / spiral.width_mm + 0.5, 0.0, 1.0);
      const int count = std::max(8, int(2 * M_PI * r_mm / 2.5));
      const double area_m2 = 2 * M_PI * r_mm * kStep_mm * 1e-6;
      for (int layer = 0; layer < kLayers; ++layer)
        for (int i = 0; i < count; ++i) {
          const double angle = 2 * M_PI * (i + 0.5 * layer) / count;
          const double z_mm = spiral.height_mm * ((layer + 0.5) / kLayers - 0.5);
          places.push_back(spiral.centre_mm +
                           Eigen::Vector3d(r_mm * std::cos(angle), r_mm * std::sin(angle), z_mm));
          moments.emplace_back(0, 0, spiral.sense * turns * area_m2 / (count * kLayers));
        }
    }
  }
  CoilDipoles coil;
  coil.positions_mm = Eigen::Map<const Eigen::Matrix3Xd>(places[0].data(), 3, Eigen::Index(places.size()));
  coil.moments_Am2 = Eigen::Map<const Eigen::Matrix3Xd>(moments[0].data(), 3, Eigen::Index(moments.size()));
  return coil;
}

/// Field on the axis below a coil that lies on a scalp of 92 mm, V/m at 66 A/us.
double underCentre(const CoilDipoles& coil, double depth_mm, double gap_mm = 0) {
  const Eigen::Vector3d centre_mm(0, 0, 92 + gap_mm);
  const Eigen::Matrix3Xd point = Eigen::Vector3d(0, 0, gap_mm + depth_mm);
  return 66 * sphereField(coil, CoilPose(), centre_mm, point).norm();
}

TEST(FigureEight, IsTheMomentMatchedSetOf42Dipoles) {
  const auto coil = figureEight70();
  ASSERT_EQ(coil.positions_mm.cols(), 42);
  const Eigen::Vector3d wing(44, 0, -6.5);
  EXPECT_NEAR((coil.positions_mm.col(0) - wing).norm(), 0, 1e-9);
  EXPECT_NEAR(std::abs(coil.moments_Am2(2, 0)), 5.1167964e-3, 1e-7);
  EXPECT_NEAR((coil.positions_mm.col(1) - wing).norm(), 23.80544, 3e-4);
  EXPECT_NEAR(std::abs(coil.moments_Am2(2, 1)), 2.2017721e-3, 5e-8);
  EXPECT_NEAR((coil.positions_mm.col(11) - wing).norm(), 37.734506, 3e-4);
  EXPECT_NEAR(std::abs(coil.moments_Am2(2, 11)), 8.3550493e-4, 2e-8);
  EXPECT_NEAR(std::abs(coil.moments_Am2.leftCols<21>().sum()), 3.5489567e-2, 1e-7);
  EXPECT_NEAR(coil.moments_Am2.sum(), 0, 1e-12) << "the wings are opposite";
}

TEST(FigureEight, HasTheGoldenFieldBelowItsCentre) {
  const auto coil = figureEight70();
  const std::vector<std::pair<double, double>> by_depth{{10, 131.20}, {15, 102.83}, {20, 80.66},
                                                        {25, 63.41},  {30, 49.93},  {40, 30.92}};
  for (const auto& [depth_mm, field] : by_depth) EXPECT_NEAR(underCentre(coil, depth_mm), field, 0.006);
  const std::vector<std::pair<double, double>> by_gap{{1, 77.30}, {2, 74.11}, {5, 65.43}, {10, 53.46}};
  for (const auto& [gap_mm, field] : by_gap) EXPECT_NEAR(underCentre(coil, 20, gap_mm), field, 0.006);
}

TEST(FigureEight, DrivesTheFieldUnderItsCentreAlongMinusY) {
  const Eigen::Matrix3Xd point = Eigen::Vector3d(0, 0, 20);
  const auto coil = figureEight70();
  for (const Eigen::Vector3d& field :
       {Eigen::Vector3d(primaryField(coil, CoilPose(), point).col(0)),
        Eigen::Vector3d(sphereField(coil, CoilPose(), Eigen::Vector3d(0, 0, 92), point).col(0))}) {
    EXPECT_LT(field.y(), 0);
    EXPECT_NEAR(std::hypot(field.x(), field.z()) / field.norm(), 0, 1e-9);
  }
}

TEST(FigureEight, AgreesWithItsWindingOfManyDipoles) {
  const auto many = manyDipoles(figureEightWinding());
  EXPECT_GT(many.positions_mm.cols(), 15000);
  EXPECT_NEAR(underCentre(many, 20), 80.97, 0.05);
  EXPECT_LT(relativeErrorInSphere(figureEight70(), many), 0.008) << "12 mm deep and below";
}

TEST(RoundCoil, AgreesWithItsWindingOfManyDipoles) {
  const auto many = manyDipoles(roundWinding());
  EXPECT_LE(roundCoil().positions_mm.cols(), 100);
  EXPECT_LT(relativeErrorInSphere(roundCoil(), many), 0.003) << "12 mm deep and below";
}

TEST(RoundCoil, HasNoFieldOnItsAxisAndARingBelowTheWinding) {
  const auto coil = roundCoil();
  EXPECT_NEAR(underCentre(coil, 20), 0, 1e-6);
  const Eigen::Matrix3Xd point = Eigen::Vector3d(45, 0, 25);
  const Eigen::Vector3d field = sphereField(coil, CoilPose(), Eigen::Vector3d(0, 0, 92), point).col(0);
  EXPECT_GT(field.norm(), 0.3) << "V/m at 1 A/us";
  // Counter-clockwise seen from above the head: its moment points out of the head, along -z.
  const auto arrows = currentArrows(coil);
  for (const auto& arrow : arrows) {
    const Eigen::Vector3d round = Eigen::Vector3d(arrow.place_mm.x(), arrow.place_mm.y(), 0);
    if (round.norm() <= 20) continue;
    EXPECT_LT(round.cross(arrow.along).z(), 0) << round.transpose();
  }
  EXPECT_GT(arrows.size(), 20u);
}

TEST(MatchedDipoles, RefuseARuleThatTheyCannotMake) {
  EXPECT_THROW(matchedDipoles(roundWinding(), 0, 10), Error);
  EXPECT_THROW(matchedDipoles(roundWinding(), 9, 10), Error);
}

TEST(CurrentArrows, FollowTheWireAsInTheFile) {
  // A loop of wire about the origin, current from +x to +y.
  LineElements loop;
  loop.positions_mm.resize(3, 90);
  loop.lengths_mm.resize(3, 90);
  for (int i = 0; i < 90; ++i) {
    const double angle = 2 * M_PI * i / 90;
    loop.positions_mm.col(i) << 40 * std::cos(angle), 40 * std::sin(angle), -6;
    loop.lengths_mm.col(i) << -40 * std::sin(angle), 40 * std::cos(angle), 0;
    loop.lengths_mm.col(i) *= 2 * M_PI / 90;
  }
  for (const auto& arrow : currentArrows(dipolesOf(loop))) {
    const Eigen::Vector3d along(-arrow.place_mm.y(), arrow.place_mm.x(), 0);
    EXPECT_GT(arrow.along.dot(along.normalized()), 0.9) << arrow.place_mm.transpose();
    EXPECT_NEAR(arrow.along.norm(), 1, 1e-12);
  }
  for (const auto& arrow : currentArrows(figureEight70())) {
    if (std::abs(arrow.place_mm.x()) >= 10 || std::abs(arrow.place_mm.y()) >= 20) continue;
    EXPECT_GT(arrow.along.y(), 0.9) << "against the field under the centre";
  }
}

TEST(ThinnedCoil, KeepsTheFieldOfAMeasuredCoilsDipoles) {
  // About a thousand dipoles, spread over the height of the wire, as in files of measured coils.
  auto some = matchedDipoles(figureEightWinding(), 4, 60);
  for (Eigen::Index i = 0; i < some.positions_mm.cols(); ++i)
    some.positions_mm(2, i) += 3.5 * std::sin(2.4 * double(i));
  const auto more = matchedDipoles(figureEightWinding(), 3, 100);
  some.positions_mm.conservativeResize(3, some.positions_mm.cols() + more.positions_mm.cols());
  some.moments_Am2.conservativeResize(3, some.positions_mm.cols());
  some.positions_mm.rightCols(more.positions_mm.cols()) = more.positions_mm;
  some.moments_Am2.rightCols(more.positions_mm.cols()) = more.moments_Am2;
  some.largest_didt_A_per_us = 114.73;
  some.name = "D70";
  EXPECT_GT(some.positions_mm.cols(), 1000);
  const auto thinned = thinnedCoil(some);
  EXPECT_LE(thinned.coil.positions_mm.cols(), 100);
  EXPECT_LE(thinned.relative_error, 0.005);
  EXPECT_GT(thinned.relative_error, 0);
  EXPECT_NEAR(relativeErrorInSphere(thinned.coil, some), thinned.relative_error, 1e-9);
  EXPECT_EQ(thinned.coil.name, some.name);
  EXPECT_EQ(thinned.coil.largest_didt_A_per_us, some.largest_didt_A_per_us);
}

TEST(ThinnedCoil, KeepsTheFieldOfAWindingOfWires) {
  const auto many = manyDipoles(roundWinding());
  const auto thinned = thinnedCoil(many);
  EXPECT_LE(thinned.coil.positions_mm.cols(), 100);
  EXPECT_LE(thinned.relative_error, 0.005);
}

TEST(ThinnedCoil, LeavesFewDipolesAndBentCoilsAlone) {
  const auto few = figureEight70();
  EXPECT_EQ(thinnedCoil(few).coil.positions_mm, few.positions_mm);
  CoilDipoles bent = manyDipoles(roundWinding());
  bent.positions_mm.row(2).array() += 12;
  EXPECT_EQ(thinnedCoil(bent).coil.positions_mm.cols(), bent.positions_mm.cols());
}

}  // namespace
}  // namespace facenav::efield
