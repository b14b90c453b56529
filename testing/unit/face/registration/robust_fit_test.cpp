#include "fit/robust_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

#include "fit/skin_likelihood.h"
#include "model_field.h"

#include "facenav/geometry/normal_equations.h"
#include "facenav/geometry/rotation.h"

namespace facenav::registration {
namespace {

using facenav::testing::facing;
using testing::allOf;
using testing::modelFace;
using testing::modelField;

double apart_mm(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  const Eigen::Vector3d target(-40, -10, 60);
  return (a * b.inverse() * target - target).norm();
}

std::vector<PointMatch> matchesOf(const std::vector<float>& residuals_mm) {
  std::vector<PointMatch> matches;
  for (const float r : residuals_mm) {
    PointMatch match;
    match.residual_mm = r, match.is_valid = true;
    match.normal_mri = Eigen::Vector3f::UnitY();
    // On a grid of 1 mm: 100 points to a patch of 10 mm.
    const int i = int(matches.size());
    match.at_mri_mm = {0.5f + float(i % 10) + 10.f * float(i / 100), 100.f, 0.5f + float(i / 10 % 10)};
    matches.push_back(match);
  }
  return matches;
}

std::vector<float> normalResiduals(int count, double sigma_mm, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<float> normal(0, float(sigma_mm));
  std::vector<float> out;
  for (int i = 0; i < count; ++i) out.push_back(normal(random));
  return out;
}

TEST(InlierLimit, IsFourStandardDeviationsWhateverTheOutliers) {
  auto residuals = normalResiduals(4000, 0.25, 1);
  EXPECT_NEAR(inlierLimit_mm(matchesOf(residuals), 5.0), 1.0, 0.05);
  for (int i = 0; i < 2000; ++i) residuals.push_back(i % 2 ? 9.0f : -30.0f);  // beyond the reach
  EXPECT_NEAR(inlierLimit_mm(matchesOf(residuals), 5.0), 1.0, 0.05);
}

TEST(InlierLimit, StaysBetweenSixTenthsAndThreeMillimetres) {
  EXPECT_EQ(inlierLimit_mm(matchesOf(normalResiduals(500, 0.01, 2)), 5.0), 0.6);
  EXPECT_EQ(inlierLimit_mm(matchesOf(normalResiduals(500, 3.0, 3)), 20.0), 3.0);
  EXPECT_EQ(inlierLimit_mm({}, 5.0), 0.6);
  auto invalid = matchesOf(normalResiduals(500, 3.0, 3));
  for (auto& match : invalid) match.is_valid = false;
  EXPECT_EQ(inlierLimit_mm(invalid, 20.0), 0.6) << "without a counterpart none counts";
}

TEST(PatchWeights, APatchThatIsLiftedAsAWholeHasNoneAndNoiseCostsNothing) {
  auto residuals = normalResiduals(1000, 0.1, 4);  // ten patches
  for (std::size_t i = 300; i < 400; ++i) residuals[i] += 1.6f;
  auto matches = matchesOf(residuals);
  matches[5].residual_mm = 3.0f;  // one outlier does not discard its patch
  matches[6].is_valid = false;
  const auto weights = patchWeights(matches, 4.0);
  ASSERT_EQ(weights.size(), matches.size());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (i == 6 || (i >= 300 && i < 400))
      EXPECT_EQ(weights[i], 0.0f) << i;
    else
      EXPECT_GT(weights[i], 0.8f) << i;
  }
}

TEST(PatchWeights, APatchOfThreePointsSaysNothing) {
  const auto weights = patchWeights(matchesOf({0.f, 0.f, 0.f}), 4.0);
  EXPECT_EQ(weights, std::vector<float>(3, 0.0f));
}

/// Face with an object 12 to 18 mm before the patient's right cheek and jaw.
struct Covered {
  PointCloud<Camera> face;
  std::vector<bool> is_covered;
};
Covered coveredFace(const RigidTransform<Camera, Mri>& truth) {
  Covered out{modelFace(truth, 8000), {}};
  const Eigen::Isometry3d mri_T_camera = truth.isometry().inverse();
  std::mt19937 random(6);
  std::uniform_real_distribution<double> before_mm(12, 18);
  for (auto& p : out.face.points_mm) {
    const Eigen::Vector3d at = mri_T_camera * p;
    out.is_covered.push_back(at.x() > 12 && at.z() < 0);
    if (out.is_covered.back()) p -= before_mm(random) * p.normalized();
  }
  return out;
}

TEST(RobustFit, AnObjectBeforeTheCheekNeitherPullsNorCounts) {
  const auto truth = facing(8, -4, 10);
  const Covered covered = coveredFace(truth);
  const Eigen::Isometry3d right = truth.isometry().inverse();
  Vector6d off = Vector6d::Zero();
  off << 0.03, -0.02, 0.02, 2, -2, 2;
  const RobustFit fit =
      fitFace(modelField(), covered.face, increment(off, modelField().middle_mm(), right), 0.0);
  EXPECT_LT(apart_mm(fit.mri_T_camera, right), 0.25);
  EXPECT_LT(rotationAngle((fit.mri_T_camera * right.inverse()).linear()), 0.2 * kRadPerDeg);
  EXPECT_GE(fit.limit_mm, 0.6);
  EXPECT_LE(fit.limit_mm, 1.5);
  int on_object = 0;
  for (const int p : fit.points) on_object += covered.is_covered[std::size_t(p)];
  EXPECT_LT(on_object, 0.02 * double(fit.points.size()));
  EXPECT_GT(fit.points.size(), 2500u);
  // The doubt from parts of the face is a covariance.
  EXPECT_LT((fit.doubt - fit.doubt.transpose()).norm(), 1e-9);
  EXPECT_GT(principalAxes(fit.doubt).values[0], -1e-9);
}

TEST(RobustFit, EvenPointsAreAMillimetreApartAndBare) {
  const auto truth = facing(8, -4, 10);
  const Covered covered = coveredFace(truth);
  RobustFit fit;
  fit.mri_T_camera = truth.isometry().inverse();
  const auto all = allOf(covered.face);
  fit.covers = Covers(modelField(), covered.face, all, fit.mri_T_camera, 0.0);
  const auto even = evenPoints(modelField(), covered.face, fit);
  EXPECT_LE(even.size(), 10000u);
  int on_object = 0;
  for (const int p : even) on_object += covered.is_covered[std::size_t(p)];
  EXPECT_LT(on_object, 0.03 * double(even.size()));
  EXPECT_GT(even.size(), 2500u);
}

TEST(RobustFit, WithoutAGuessThereIsNone) {
  EXPECT_FALSE(fitFromGuess(modelField(), modelFace(facing(0, 0, 0)), {}));
}

TEST(PartFits, TheLikeliestIsTheHeadAndNoneIsRuledOut) {
  const auto truth = facing(-12, 5, -20);
  const auto face = modelFace(truth, 1500);
  const Eigen::Isometry3d right = truth.isometry().inverse();
  Vector6d off = Vector6d::Zero();
  off << 0.03, 0.03, -0.03, 3, 2, -3;
  const auto fits =
      fitParts(modelField(), face, allOf(face), increment(off, modelField().middle_mm(), right), 0.0);
  ASSERT_FALSE(fits.empty());
  EXPECT_LT(apart_mm(fits.front().mri_T_camera, right), 0.4);
  for (std::size_t i = 1; i < fits.size(); ++i) {
    EXPECT_GE(fits[i - 1].log_likelihood, fits[i].log_likelihood);
    EXPECT_GE(fits[i].log_likelihood, fits.front().log_likelihood - 8.0);
    EXPECT_TRUE(
        areDistinct(fits[i].mri_T_camera, fits[0].mri_T_camera, modelField().middle_mm(), 0.002, 0.2));
  }
}

TEST(SkinLikelihood, IsHighestAtTheHeadAndFallsWithTheDistance) {
  const auto truth = facing(5, -5, 0);
  const auto face = modelFace(truth, 1500);
  const FieldFitter fitter(modelField(), face, allOf(face));
  const SkinLikelihood logLikelihood(modelField(), face, allOf(face), 0.0);
  const Eigen::Isometry3d right = truth.isometry().inverse();
  const double here = logLikelihood(fitter.match(right));
  for (int axis = 0; axis < 6; ++axis) {
    double last = here;
    for (const double step : {1.0, 2.0, 4.0}) {
      Vector6d off = Vector6d::Zero();
      off[axis] = axis < 3 ? step * 1.5 * kRadPerDeg : step * 1.5;
      const double there = logLikelihood(fitter.match(increment(off, modelField().middle_mm(), right)));
      EXPECT_LT(there, last) << "axis " << axis << ", step " << step;
      last = there;
    }
  }
}

TEST(SkinLikelihood, SaysWhichPatchesAreCovered) {
  const auto truth = facing(5, -5, 0);
  const Covered covered = coveredFace(truth);
  std::vector<int> points;
  for (int p = 0; p < 3000; ++p) points.push_back(p);
  const auto share =
      SkinLikelihood(modelField(), covered.face, points, 0.0, 12.0)
          .covered(FieldFitter(modelField(), covered.face, points).match(truth.isometry().inverse()));
  ASSERT_EQ(share.size(), points.size());
  double on_object = 0, on_skin = 0;
  int objects = 0, skins = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    EXPECT_GE(share[p], 0.0f);
    EXPECT_LE(share[p], 1.0f);
    if (covered.is_covered[p])
      on_object += double(share[p]), ++objects;
    else
      on_skin += double(share[p]), ++skins;
  }
  EXPECT_GT(on_object / objects, 0.95);
  EXPECT_LT(on_skin / skins, 0.05);
}

}  // namespace
}  // namespace facenav::registration
