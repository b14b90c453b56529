// Masks of shapes whose overlap and distance are known, perturbations of volumes, and the surface error.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "facenav/core/error.h"
#include "facenav/evaluation/doubt_reliability.h"
#include "facenav/evaluation/mask_agreement.h"
#include "facenav/evaluation/volume_perturbation.h"

namespace facenav::evaluation {
namespace {

using volume::Mask;

/// Mask of the voxels whose centres are inside; `size` voxels per side about the origin.
Mask maskOf(int size, const Eigen::Vector3d& spacing_mm,
            const std::function<bool(const Eigen::Vector3d&)>& inside) {
  Mask mask;
  mask.grid.size = {size, size, size};
  mask.grid.mri_from_voxel.linear() = spacing_mm.asDiagonal();
  mask.grid.mri_from_voxel.translation() = -0.5 * (size - 1) * spacing_mm;
  for (int k = 0; k < size; ++k)
    for (int j = 0; j < size; ++j)
      for (int i = 0; i < size; ++i)
        mask.voxels.push_back(inside(mask.grid.toMri(Eigen::Vector3d(i, j, k)).mm));
  return mask;
}

Mask ball(double radius_mm, const Eigen::Vector3d& centre_mm = Eigen::Vector3d::Zero(),
          double spacing_mm = 1) {
  return maskOf(int(64 / spacing_mm), Eigen::Vector3d::Constant(spacing_mm),
                [&](const Eigen::Vector3d& p) { return (p - centre_mm).norm() <= radius_mm; });
}

TEST(MaskShapes, ConcentricBallsAgreeAsTheirVolumesSay) {
  const double small = 18, large = 22;
  const auto agreement = compareMasks(ball(small), ball(large));
  const double ratio = std::pow(small / large, 3);
  EXPECT_NEAR(agreement.dice, 2 * ratio / (1 + ratio), 0.01);
  EXPECT_EQ(agreement.inside, 1.0) << "the found one lies inside the true one";
  EXPECT_NEAR(agreement.hausdorff95_mm, large - small, 0.9) << "voxels of 1 mm";
  EXPECT_NEAR(agreement.mean_distance_mm, large - small, 0.5);
  EXPECT_NEAR(agreement.found_ml, 4.0 / 3 * M_PI * std::pow(small, 3) / 1000, 0.3);
}

TEST(MaskShapes, ExchangedMasksHaveTheSameDistancesAndOtherShares) {
  const Mask a = ball(18), b = ball(22, {3, 0, 0});
  const auto forth = compareMasks(a, b), back = compareMasks(b, a);
  EXPECT_DOUBLE_EQ(forth.dice, back.dice);
  EXPECT_DOUBLE_EQ(forth.hausdorff95_mm, back.hausdorff95_mm);
  EXPECT_NEAR(forth.mean_distance_mm, back.mean_distance_mm, 1e-9);
  EXPECT_DOUBLE_EQ(forth.found_ml, back.true_ml);
  EXPECT_GT(forth.inside, back.inside);
}

TEST(MaskShapes, DistancesAreInMillimetresAlongEachAxis) {
  const Eigen::Vector3d spacing_mm(1, 2, 3);
  for (int axis = 0; axis < 3; ++axis) {
    const auto slab = [&](double shift_voxels) {
      return maskOf(24, spacing_mm, [&](const Eigen::Vector3d& p) {
        Eigen::Vector3d v = p.cwiseQuotient(spacing_mm);
        v[axis] -= shift_voxels;
        return v.cwiseAbs().maxCoeff() < 6;
      });
    };
    EXPECT_DOUBLE_EQ(compareMasks(slab(0), slab(2)).hausdorff95_mm, 2 * spacing_mm[axis]) << axis;
  }
}

TEST(MaskShapes, AFinerGridOfTheSameShapeIsTheSame) {
  const auto agreement = compareMasks(ball(20, {0, 0, 0}, 0.5), ball(20));
  EXPECT_GT(agreement.dice, 0.98);
  EXPECT_LE(agreement.hausdorff95_mm, 1.0);
}

TEST(MaskShapes, DisjointShapesShareNothing) {
  const auto agreement = compareMasks(ball(6, {-15, 0, 0}), ball(6, {15, 0, 0}));
  EXPECT_EQ(agreement.dice, 0);
  EXPECT_EQ(agreement.inside, 0);
  EXPECT_GT(agreement.hausdorff95_mm, 18) << "surfaces at least 18 mm apart";
  EXPECT_LE(agreement.hausdorff95_mm, 30 + 1);
  EXPECT_THROW(compareMasks(ball(6), ball(6, {200, 0, 0})), Error) << "an empty truth";
}

TEST(MaskShapes, ClosingAndFillingChangeNoConvexShape) {
  const Mask whole = ball(20);
  EXPECT_GT(volume::overlap(closedAndFilled(whole, 2), whole).dice, 0.99) << "steps of voxels may be bridged";
  Mask hollow = whole;
  const Mask inner = ball(8);
  for (std::size_t v = 0; v < hollow.voxels.size(); ++v) hollow.voxels[v] &= !inner.voxels[v];
  const Mask filled = closedAndFilled(hollow, 1);
  EXPECT_TRUE(filled.at(32, 32, 32)) << "the hole is filled";
  EXPECT_GT(volume::overlap(filled, whole).dice, 0.99);
}

TEST(SurfaceError, IsTheDistanceToTheBallsSurfaceFromBothSides) {
  const SurfaceError error(ball(20));
  for (const double r : {10.0, 19.5, 25.0, 30.0})  // at the centre the voxel steps of all directions count
    for (const Eigen::Vector3d& d : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0.6, -0.8, 0)})
      EXPECT_NEAR(error.at_mm(Point<Mri>(r * d)), std::abs(r - 20), 1.3) << r;
  EXPECT_NEAR(error.at_mm(Point<Mri>(500, 0, 0)), 32 - 20, 1.5) << "as at the grid's edge";
}

TEST(Reliability, ADoubtOnTheLimitBelongsToTheLowerBin) {
  const auto binOf = [](double doubt_mm) {
    const auto bins = reliabilityOf({{doubt_mm, 1}});
    for (std::size_t b = 0; b < bins.size(); ++b)
      if (bins[b].places) return int(b);
    return -1;
  };
  EXPECT_EQ(binOf(0), 0);
  EXPECT_EQ(binOf(1), 0);
  EXPECT_EQ(binOf(1.0001), 1);
  EXPECT_EQ(binOf(2), 1);
  EXPECT_EQ(binOf(8), 4);
  EXPECT_EQ(binOf(8.0001), 5);
  EXPECT_EQ(binOf(500), 5);
}

TEST(Reliability, SharesSumToOneAndCertaintyEndsAtTwoMillimetres) {
  std::vector<DoubtedPlace> places;
  for (int i = 0; i < 100; ++i) places.push_back({0.1 * i, i < 40 ? 2.0 : 2.01});
  const auto row = reliabilityRow("v", "m", "t", places);
  double sum = 0;
  for (const auto& bin : row.bins) sum += bin.share;
  EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_NEAR(row.really_certain, 0.40, 1e-12);
  EXPECT_NEAR(row.stated_certain, 0.21, 1e-12);
  EXPECT_EQ(reliabilityRow("", "", "", {}).stated_certain, 0.0);
}

volume::Volume softBall() {
  volume::Volume mri;
  const Mask mask = ball(20, {3, -2, 1});
  mri.grid = mask.grid;
  for (int k = 0; k < 64; ++k)
    for (int j = 0; j < 64; ++j)
      for (int i = 0; i < 64; ++i) {
        const double r = (mri.grid.toMri(Eigen::Vector3d(i, j, k)).mm - Eigen::Vector3d(3, -2, 1)).norm();
        mri.voxels.push_back(r < 20 ? float(100 + 3 * r) : 5.f);
      }
  return mri;
}

TEST(Perturbation, APointComesBackWhereItsVoxelCameFrom) {
  const auto mri = softBall();
  const Mask brain = ball(20, {3, -2, 1});
  for (const auto& all : {standardPerturbations(), hardHeads()})
    for (const auto& p : all) {
      if (p.spacing_mm > 0 || p.neck_mm > 0) continue;  // the voxels differ
      const auto other = perturbed(mri, brain, p, 3);
      ASSERT_EQ(other.voxels.size(), mri.voxels.size()) << p.name;
      for (const Eigen::Vector3d& ijk : {Eigen::Vector3d(0, 0, 0), {10, 40, 22}, {63, 5, 60}})
        EXPECT_LT((unperturbed(other.grid.toMri(ijk), mri.grid, p).mm - mri.grid.toMri(ijk).mm).norm(), 1e-9)
            << p.name;
    }
}

TEST(Perturbation, AChildsHeadIsSmallerByItsFactorInEachDirection) {
  const auto mri = softBall();
  for (const auto& p : hardHeads()) {
    if (p.size == 1) continue;
    const auto other = perturbed(mri, ball(20), p, 1);
    EXPECT_NEAR(other.grid.voxelVolume_mm3(), std::pow(p.size, 3), 1e-9) << p.name;
  }
}

TEST(Perturbation, GainAndToneKeepTheOrderOfTheValues) {
  const auto mri = softBall();
  const Mask none{mri.grid, std::vector<std::uint8_t>(mri.grid.count())};
  VolumePerturbation gain, tone;
  gain.gain = 50;
  tone.gamma = 0.55;
  const auto brighter = perturbed(mri, none, gain, 1), flatter = perturbed(mri, none, tone, 1);
  const auto contrast = [](const volume::Volume& v) { return v.at(34, 30, 44) / v.at(34, 30, 33); };
  ASSERT_GT(contrast(mri), 1.1f);
  EXPECT_NEAR(contrast(brighter), contrast(mri), 1e-5);
  EXPECT_NEAR(brighter.at(34, 30, 33), 50 * mri.at(34, 30, 33), 1e-2);
  EXPECT_GT(contrast(flatter), 1.0f);
  EXPECT_LT(contrast(flatter), contrast(mri)) << "below 1: contrast is flattened";
}

TEST(Perturbation, ABiasFieldIsSmoothAndOfTheStatedSize) {
  volume::Volume flat = softBall();
  std::fill(flat.voxels.begin(), flat.voxels.end(), 100.f);
  const Mask none{flat.grid, std::vector<std::uint8_t>(flat.grid.count())};
  VolumePerturbation p;
  p.bias = 0.4;
  const auto biased = perturbed(flat, none, p, 7);
  double steepest = 0, most = 0;
  for (int k = 0; k < 64; ++k)
    for (int j = 0; j < 64; ++j)
      for (int i = 0; i + 1 < 64; ++i) {
        const double here = std::log(biased.at(i, j, k) / 100), next = std::log(biased.at(i + 1, j, k) / 100);
        steepest = std::max(steepest, std::abs(next - here));
        most = std::max(most, std::abs(here));
      }
  EXPECT_LE(most, 0.4 * 1.5 + 1e-6);
  EXPECT_GT(most, 0.02);
  EXPECT_LT(steepest, 0.02) << "per mm";
  EXPECT_NE(perturbed(flat, none, p, 8).voxels, biased.voxels) << "another seed, another field";
}

TEST(Perturbation, ScalpNoiseStaysAwayFromTheBrain) {
  volume::Volume flat = softBall();
  std::fill(flat.voxels.begin(), flat.voxels.end(), 100.f);
  VolumePerturbation p;
  p.scalp_noise = 0.2;
  const auto noisy = perturbed(flat, ball(15), p, 2);
  double outside = 0;
  for (int k = 0; k < 64; ++k)
    for (int j = 0; j < 64; ++j)
      for (int i = 0; i < 64; ++i) {
        const double r = flat.grid.toMri(Eigen::Vector3d(i, j, k)).mm.norm();
        const double change = std::abs(noisy.at(i, j, k) - 100.f);
        if (r < 15 + 5) {
          ASSERT_EQ(change, 0.0) << r;
        }
        if (r > 15 + 8) outside += change > 1;
      }
  EXPECT_GT(outside, 100000);
}

}  // namespace
}  // namespace facenav::evaluation
