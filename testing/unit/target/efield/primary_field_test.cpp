#include "facenav/efield/primary_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "efield_scene.h"

namespace facenav::efield {
namespace {

using CoilPose = RigidTransform<Mri, frames::Coil>;

/// One dipole, in the frame Mri.
CoilDipoles dipole(const Eigen::Vector3d& place_m, const Eigen::Vector3d& moment) {
  CoilDipoles coil;
  coil.positions_mm = 1000 * place_m;
  coil.moments_Am2 = moment;
  return coil;
}

Eigen::Vector3d inSphere(const CoilDipoles& coil, const Eigen::Vector3d& r_m) {
  return sphereField(coil, CoilPose(), Eigen::Vector3d::Zero(), Eigen::Matrix3Xd(1000 * r_m)).col(0);
}

struct RandomDipoles {
  std::mt19937 random{7};
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  }
  Eigen::Vector3d direction() {
    std::normal_distribution<double> normal;
    return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
  }
};

// Values of an independent prototype of the closed form.
TEST(SphereField, HasTheGoldenValues) {
  const Eigen::Vector3d first = inSphere(dipole({0, 0, 0.1}, {1, 0, 0}), {0, 0.03, 0.07});
  EXPECT_NEAR(first.x(), 0, 1e-9);
  EXPECT_NEAR(first.y(), -22.780584, 1e-6);
  EXPECT_NEAR(first.z(), 9.763107, 1e-6);
  const Eigen::Vector3d second = inSphere(dipole({0.02, -0.01, 0.1}, {0.3, -0.2, 1}), {0.01, 0.03, 0.06});
  EXPECT_NEAR(second.x(), 19.959775, 1e-6);
  EXPECT_NEAR(second.y(), 0.168194, 1e-6);
  EXPECT_NEAR(second.z(), -3.410726, 1e-6);
}

TEST(SphereField, HasNoRadialPartAndNoneAtTheCentre) {
  RandomDipoles make;
  for (int i = 0; i < 200; ++i) {
    const auto coil = dipole(make.between(0.095, 0.15) * make.direction(), make.direction());
    const Eigen::Vector3d r_m = make.between(0.005, 0.08) * make.direction();
    const Eigen::Vector3d field = inSphere(coil, r_m);
    EXPECT_NEAR(field.dot(r_m.normalized()) / field.norm(), 0, 1e-11);
    EXPECT_NEAR(inSphere(coil, Eigen::Vector3d::Zero()).norm(), 0, 1e-12);
  }
}

TEST(SphereField, OfARadialDipoleIsItsPrimaryField) {
  RandomDipoles make;
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d out = make.direction();
    const auto coil = dipole(make.between(0.095, 0.15) * out, 0.3 * out);
    const Eigen::Matrix3Xd point = 1000 * make.between(0.005, 0.08) * make.direction();
    const Eigen::Vector3d primary = primaryField(coil, CoilPose(), point).col(0);
    const Eigen::Vector3d total = sphereField(coil, CoilPose(), Eigen::Vector3d::Zero(), point).col(0);
    EXPECT_NEAR((total - primary).norm() / primary.norm(), 0, 1e-10);
  }
}

// The secondary field has a potential, so both fields have the same curl: that of -dB/dt.
TEST(SphereField, HasTheCurlOfThePrimaryField) {
  RandomDipoles make;
  for (int i = 0; i < 20; ++i) {
    const auto coil = dipole(make.between(0.095, 0.15) * make.direction(), make.direction());
    const Eigen::Vector3d r_mm = 1000 * make.between(0.02, 0.07) * make.direction();
    const auto curl = [&](auto field) {
      Eigen::Matrix3d change;
      for (int c = 0; c < 3; ++c) {
        const Eigen::Vector3d step = 0.05 * Eigen::Vector3d::Unit(c);
        change.col(c) = (field(r_mm + step) - field(r_mm - step)) / 0.1;
      }
      return Eigen::Vector3d(change(2, 1) - change(1, 2), change(0, 2) - change(2, 0),
                             change(1, 0) - change(0, 1));
    };
    const Eigen::Vector3d primary = curl([&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
      return primaryField(coil, CoilPose(), Eigen::Matrix3Xd(p)).col(0);
    });
    const Eigen::Vector3d total = curl([&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
      return sphereField(coil, CoilPose(), Eigen::Vector3d::Zero(), Eigen::Matrix3Xd(p)).col(0);
    });
    EXPECT_NEAR((total - primary).norm() / primary.norm(), 0, 1e-5);
  }
}

/// B along `moment` of a current dipole, in fT, by reciprocity: a coil of 1 A m2 whose current rises by 1
/// A/us = 1e6 A/s induces E at the source, and B.n = -E.Q / 1e6.
double byReciprocity_fT(const Eigen::Vector3d& place_m, const Eigen::Vector3d& moment,
                        const Eigen::Vector3d& source_m, const Eigen::Vector3d& current_nAm) {
  return -inSphere(dipole(place_m, moment), source_m).dot(current_nAm) / 1e6 * 1e-9 * 1e15;
}

TEST(SphereField, GivesTheFieldsOfMagnetoencephalographyByReciprocity) {
  RandomDipoles make;
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d place_m = make.between(0.1, 0.13) * make.direction(), along = make.direction();
    const Eigen::Vector3d source_m = make.between(0.02, 0.085) * make.direction(),
                          current_nAm = 10 * make.direction();
    const Eigen::Vector3d sarvas_fT = 1e15 * testing::sarvasField(source_m, 1e-9 * current_nAm, place_m);
    EXPECT_NEAR(byReciprocity_fT(place_m, along, source_m, current_nAm), sarvas_fT.dot(along),
                1e-3 * std::abs(sarvas_fT.dot(along)) + 1e-9);
    // The radial part needs no volume currents (Biot and Savart alone).
    const Eigen::Vector3d out = place_m.normalized(), a = place_m - source_m;
    const double radial_fT = 1e15 * 1e-7 * 1e-9 * current_nAm.cross(a).dot(out) / std::pow(a.norm(), 3);
    EXPECT_NEAR(byReciprocity_fT(place_m, out, source_m, current_nAm), radial_fT,
                1e-3 * std::abs(radial_fT) + 1e-9);
  }
}

TEST(SphereField, GivesTheFieldUnderASensorThatCanBeWorkedOutByHand) {
  // 10 nA m along x, 70 mm above the centre; sensors 120 mm from it. Radial, at 45 degrees in the y-z plane:
  // B = 1e-7 Q z_source y / a^3 with the signs of (Q x a).out.
  const double h = 0.12 * std::sqrt(0.5);
  const Eigen::Vector3d source_m(0, 0, 0.07), place_m(0, h, h), out(0, std::sqrt(0.5), std::sqrt(0.5));
  const double a_m = std::sqrt(h * h + (h - 0.07) * (h - 0.07));
  // Q x a = 10 nA m (0, -(h - 0.07), h); along out: 10 nA m sqrt(0.5) 0.07 m.
  const double radial_fT = 1e15 * 1e-7 * 1e-8 * std::sqrt(0.5) * 0.07 / std::pow(a_m, 3);
  EXPECT_NEAR(byReciprocity_fT(place_m, out, source_m, {10, 0, 0}), radial_fT, 1e-3 * radial_fT);
  // Above the source, tangential: Sarvas' equation with a = 0.05 m, r = 0.12 m, F = 0.05 * 0.012 = 6e-4 m3,
  // and Q x r0 at a right angle to r: B = 1e-7 (Q x r0) / F.
  EXPECT_NEAR(byReciprocity_fT({0, 0, 0.12}, {0, 1, 0}, source_m, {10, 0, 0}), -1e15 * 1e-7 * 7e-10 / 6e-4,
              0.12);
  // A radial current has no field outside.
  EXPECT_NEAR(byReciprocity_fT(place_m, {0.3, 0.2, -1}, source_m, {0, 0, 10}), 0, 1e-9);
}

TEST(SphereField, MovesWithCoilAndSphere) {
  const auto coil = dipole({0.02, -0.01, 0.0}, {0.3, -0.2, 1});
  const CoilPose pose(Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized())),
                      {5, -7, 120});
  const Eigen::Vector3d shift_mm(30, -20, 10), point_mm(10, 30, 60);
  const CoilPose moved(pose.quaternion(), pose.translation_mm() + shift_mm);
  const Eigen::Vector3d here =
      sphereField(coil, pose, Eigen::Vector3d(1, 2, 3), Eigen::Matrix3Xd(point_mm)).col(0);
  const Eigen::Vector3d there =
      sphereField(coil, moved, Eigen::Vector3d(1, 2, 3) + shift_mm, Eigen::Matrix3Xd(point_mm + shift_mm))
          .col(0);
  EXPECT_NEAR((here - there).norm(), 0, 1e-10);
  EXPECT_GT(here.norm(), 0.01);
}

}  // namespace
}  // namespace facenav::efield
