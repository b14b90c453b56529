// A synthetic brain (an ellipsoid with folds) and the same brain moved by a known affine map: moments, affine
// fit, demons.

#include "affine_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "demons.h"
#include "facenav/atlas/register_atlas.h"
#include "facenav/core/error.h"
#include "facenav/volume/regrid.h"

namespace facenav::atlas {
namespace {

const Eigen::Vector3d kRadii_mm(34, 44, 30);

/// T1 of the synthetic brain at a point of MNI space; 0 outside.
double made(const Eigen::Vector3d& p) {
  if (p.cwiseQuotient(kRadii_mm).norm() > 1) return 0;
  return 100 + 25 * std::sin(p.x() / 6) * std::cos(p.y() / 7) + 20 * std::sin(p.z() / 5 + p.y() / 11) +
         8 * std::sin(p.x() / 9 + 1);
}

struct Brain {
  volume::Volume t1;
  volume::Mask mask;
};

/// Scan of the brain in which a point x of MNI space lies at mri_from_mni x.
Brain scanned(const Eigen::Affine3d& mri_from_mni, int size = 60, double spacing_mm = 2.0) {
  Brain brain;
  auto& grid = brain.t1.grid;
  grid.size = {size, size, size};
  const Eigen::Vector3d middle = mri_from_mni.translation();
  grid.mri_from_voxel =
      Eigen::Translation3d(middle - Eigen::Vector3d::Constant(0.5 * (size - 1) * spacing_mm)) *
      Eigen::Scaling(spacing_mm);
  brain.mask.grid = grid;
  const Eigen::Affine3d mni_from_mri = mri_from_mni.inverse();
  for (int k = 0; k < size; ++k)
    for (int j = 0; j < size; ++j)
      for (int i = 0; i < size; ++i) {
        const double value = made(mni_from_mri * grid.toMri(Eigen::Vector3d(i, j, k)).mm);
        brain.t1.voxels.push_back(float(value));
        brain.mask.voxels.push_back(value > 0);
      }
  return brain;
}

BrainImages imagesOf(const Brain& patient, double finest_mm) {
  return BrainImages(scanned(Eigen::Affine3d::Identity()).t1, patient.t1, patient.mask, finest_mm);
}

/// Largest distance between two maps over the brain's ellipsoid.
double farthest_mm(const Eigen::Affine3d& a, const Eigen::Affine3d& b) {
  double most = 0;
  for (int n = 0; n < 60; ++n) {
    const double z = 1 - 2 * (n + 0.5) / 60, about = 2.4 * n, r = std::sqrt(1 - z * z);
    const Eigen::Vector3d p =
        kRadii_mm.cwiseProduct(Eigen::Vector3d(r * std::cos(about), r * std::sin(about), z));
    most = std::max(most, (a * p - b * p).norm());
  }
  return most;
}

Eigen::Affine3d knownAffine() {
  return Eigen::Translation3d(12, -7, 25) *
         Eigen::AngleAxisd(0.12, Eigen::Vector3d(1, 0.4, -0.3).normalized()) *
         Eigen::Scaling(1.07, 0.94, 1.05);
}

TEST(AffineFit, FindsAKnownAffineFromTheMomentsAlone) {
  const auto images = imagesOf(scanned(knownAffine()), 4.0);
  const BrainPair pair(images, 4.0);
  const auto start = affineFromMoments(pair);
  const auto fit = fitAffine(pair, start, 20);
  EXPECT_GT(farthest_mm(start, knownAffine()), 3.0) << "the start does not know the rotation";
  EXPECT_LT(farthest_mm(fit, knownAffine()), 0.8);
  EXPECT_LT(cost(pair, pair.warped(fit, nullptr)), cost(pair, pair.warped(start, nullptr)));
}

TEST(AffineFit, DoesNotDependOnGainAndHardlyOnABiasField) {
  const auto fitTo = [&](const Brain& brain) {
    const auto images = imagesOf(brain, 4.0);
    const BrainPair pair(images, 4.0);
    return fitAffine(pair, affineFromMoments(pair), 20);
  };
  auto patient = scanned(knownAffine());
  const auto plain = fitTo(patient);
  for (float& v : patient.t1.voxels) v *= 8.f;
  EXPECT_LT(farthest_mm(fitTo(patient), plain), 0.05);
  for (std::size_t n = 0; n < patient.t1.voxels.size(); ++n)  // from -20 % to +20 % along x
    patient.t1.voxels[n] *= 0.8f + 0.4f * float(n % 60) / 60.f;
  EXPECT_LT(farthest_mm(fitTo(patient), knownAffine()), 1.0);
}

TEST(AffineFit, StaysWhereItIsRight) {
  const auto images = imagesOf(scanned(Eigen::Affine3d::Identity()), 4.0);
  const BrainPair pair(images, 4.0);
  EXPECT_LT(farthest_mm(affineFromMoments(pair), Eigen::Affine3d::Identity()), 0.2);
  EXPECT_LT(farthest_mm(fitAffine(pair, Eigen::Affine3d::Identity(), 10), Eigen::Affine3d::Identity()), 0.1);
}

TEST(AffineFit, IsDeterministic) {
  const auto images = imagesOf(scanned(knownAffine()), 6.0);
  const BrainPair pair(images, 6.0);
  const auto a = fitAffine(pair, affineFromMoments(pair), 6), b = fitAffine(pair, affineFromMoments(pair), 6);
  EXPECT_EQ(a.matrix(), b.matrix());
}

TEST(BrainPair, MomentsOfAnEllipsoidAreItsCentreAndRadiiOverRootFive) {
  const Eigen::Affine3d moved(Eigen::Translation3d(20, -30, 5));
  const auto images = imagesOf(scanned(moved), 3.0);
  const BrainPair pair(images, 3.0);
  const Eigen::Vector3d expected_mm = kRadii_mm / std::sqrt(5.0);
  EXPECT_LT((pair.templateMoments().centre_mm).norm(), 0.1);
  EXPECT_LT((pair.patientMoments().centre_mm - moved.translation()).norm(), 0.1);
  for (const auto& moments : {pair.templateMoments(), pair.patientMoments()})
    EXPECT_LT((moments.deviation_mm - expected_mm).norm(), 0.4);
}

TEST(BrainPair, AgreesFullyWithItselfAndLessWhenShifted) {
  const auto images = imagesOf(scanned(Eigen::Affine3d::Identity()), 4.0);
  const BrainPair pair(images, 4.0);
  EXPECT_NEAR(pair.dice(pair.fixed()), 1.0, 1e-12);
  EXPECT_NEAR(pair.correlation(pair.fixed()), 1.0, 1e-6);
  const auto shifted = pair.warped(Eigen::Affine3d(Eigen::Translation3d(12, 0, 0)), nullptr);
  EXPECT_LT(pair.dice(shifted), 0.9);
  EXPECT_LT(pair.correlation(shifted), 0.8);
}

TEST(BrainPair, WarpedByADisplacementIsWarpedByTheSameShift) {
  const auto images = imagesOf(scanned(Eigen::Affine3d::Identity()), 4.0);
  const BrainPair pair(images, 4.0);
  auto shift = noDisplacement(pair.grid().size);
  for (float& v : shift[1].values) v = 1.5f;  // nodes of 4 mm
  const auto a = pair.warped(Eigen::Affine3d::Identity(), &shift),
             b = pair.warped(Eigen::Affine3d(Eigen::Translation3d(0, 6, 0)), nullptr);
  std::size_t differ = 0;  // a node on the brain's edge may be counted in by one and out by the other
  for (std::size_t n = 0; n < a.t1.values.size(); ++n) {
    ASSERT_NEAR(a.brain.values[n], b.brain.values[n], 1e-3);
    differ += std::abs(a.t1.values[n] - b.t1.values[n]) > 1e-2f;
  }
  EXPECT_LT(differ, a.t1.values.size() / 100);
}

TEST(BrainPair, AnEmptyBrainIsRefused) {
  auto patient = scanned(Eigen::Affine3d::Identity(), 20, 6.0);
  std::fill(patient.mask.voxels.begin(), patient.mask.voxels.end(), 0);
  EXPECT_THROW(imagesOf(patient, 6.0), Error);
}

VectorField linear(const Eigen::Matrix3f& slope) {
  VectorField d = noDisplacement({8, 8, 8});
  for (int k = 0; k < 8; ++k)
    for (int j = 0; j < 8; ++j)
      for (int i = 0; i < 8; ++i) {
        const Eigen::Vector3f v = slope * Eigen::Vector3f(float(i), float(j), float(k));
        for (int a = 0; a < 3; ++a) d[a].values[d[a].index(i, j, k)] = v[a];
      }
  return d;
}

TEST(Demons, TheJacobianOfALinearDisplacementIsItsDeterminant) {
  EXPECT_NEAR(smallestJacobian(noDisplacement({5, 5, 5})), 1.0, 1e-6);
  Eigen::Matrix3f slope;
  slope << 0.1f, 0.05f, 0, -0.02f, -0.2f, 0.03f, 0, 0.04f, 0.3f;
  EXPECT_NEAR(smallestJacobian(linear(slope)), (Eigen::Matrix3f::Identity() + slope).determinant(), 1e-4);
  EXPECT_LT(smallestJacobian(linear(Eigen::Vector3f(-1.5f, 0, 0).asDiagonal())), 0.0) << "folded";
}

TEST(Demons, OnAnotherGridTheDisplacementIsTheSameInMillimetres) {
  volume::VoxelGrid coarse, fine;
  coarse.size = {8, 8, 8};
  coarse.mri_from_voxel = Eigen::Translation3d(-10, 0, 5) * Eigen::Scaling(4.0);
  fine.size = {15, 15, 15};
  fine.mri_from_voxel = Eigen::Translation3d(-10, 0, 5) * Eigen::Scaling(2.0);
  Eigen::Matrix3f slope = Eigen::Vector3f(0.1f, -0.05f, 0.02f).asDiagonal();
  const auto d = linear(slope), on_fine = onGrid(d, coarse, fine);
  for (int n = 0; n < 15; ++n)
    for (int a = 0; a < 3; ++a) {
      const double coarse_mm = 4.0 * slope(a, a) * (n / 2.0);
      EXPECT_NEAR(2.0 * on_fine[a].at(n, n, n), coarse_mm, 1e-4) << n;
    }
}

TEST(Demons, LeaveEqualBrainsAloneAndStayInvertible) {
  const auto images = imagesOf(scanned(Eigen::Affine3d::Identity()), 6.0);
  const BrainPair pair(images, 6.0);
  const auto same =
      runDemons(pair, Eigen::Affine3d::Identity(), noDisplacement(pair.grid().size), 5, [](double) {});
  for (const auto& component : same)
    for (const float v : component.values) ASSERT_LT(std::abs(v), 0.1) << "nodes";
  const auto moved = imagesOf(scanned(Eigen::Affine3d(Eigen::Translation3d(5, 0, 0))), 6.0);
  const BrainPair other(moved, 6.0);
  double last = -1;
  const auto warp =
      runDemons(other, Eigen::Affine3d::Identity(), noDisplacement(other.grid().size), 10, [&](double part) {
        EXPECT_GT(part, last);
        EXPECT_LT(part, 1.0);
        last = part;
      });
  const auto before = other.warped(Eigen::Affine3d::Identity(), nullptr),
             after = other.warped(Eigen::Affine3d::Identity(), &warp);
  EXPECT_GT(other.dice(after), other.dice(before));
  EXPECT_GT(smallestJacobian(warp), 0.0);
}

TEST(AtlasQuality, EachOfItsThreeLimitsDecides) {
  const AtlasQuality good{0.3, 0.5, 0.95, 0.2};
  EXPECT_TRUE(good.isUsable());
  AtlasQuality poor = good;
  poor.dice = 0.9;
  EXPECT_FALSE(poor.isUsable());
  poor = good, poor.correlation = 0.3;
  EXPECT_FALSE(poor.isUsable());
  poor = good, poor.smallest_jacobian = 0;
  EXPECT_FALSE(poor.isUsable());
}

}  // namespace
}  // namespace facenav::atlas
