// Tracked or lost, and changes of the weights, from synthetic measurements.

#include "head/track_verdict.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "head/light_field.h"
#include "head/patch_weights.h"

namespace facenav::head_tracking {
namespace {

PatchMeasurement seen(bool is_good) {
  PatchMeasurement m;
  m.is_visible = true, m.ncc = is_good ? 0.9f : 0.2f, m.expected_ncc = 0.95f;
  m.weight = is_good ? 1.f : 0.f, m.residual_px = is_good ? 0.1f : 2.f;
  return m;
}

/// Fit of 100 patches, of which so many look as expected in each camera; the pose is known to 0.1 mm.
PoseFit fitWith(int good_left, int good_right) {
  PoseFit fit;
  for (int i = 0; i < 100; ++i) fit.measurements.push_back({seen(i < good_left), seen(i < good_right)});
  fit.information.diagonal() << 1e7, 1e7, 1e7, 100, 100, 100;
  fit.regions = 12;
  fit.is_settled = true;
  return fit;
}

TEST(TrackVerdict, AFaceThatLooksAsExpectedIsTracked) {
  const Verdict verdict = judge({}, fitWith(90, 85));
  EXPECT_TRUE(verdict.isTracked());
  EXPECT_NEAR(verdict.good_share[0], 0.90, 1e-9);
  EXPECT_NEAR(verdict.good_share[1], 0.85, 1e-9);
  EXPECT_NEAR(verdict.quality, 0.85 / 0.9, 1e-9) << "of the worse camera";
}

TEST(TrackVerdict, EachReasonHasItsOwnName) {
  EXPECT_EQ(judge({}, fitWith(10, 12)).lost, LostReason::few_features);
  EXPECT_EQ(judge({}, fitWith(90, 5)).lost, LostReason::camera);
  EXPECT_EQ(judge({}, fitWith(98, 24)).lost, LostReason::camera) << "less than a quarter in one camera";
  EXPECT_TRUE(judge({}, fitWith(90, 27)).isTracked());
  PoseFit unsettled = fitWith(90, 90), spread = fitWith(90, 90);
  unsettled.is_settled = false;
  spread.scale = 6.5;
  EXPECT_EQ(judge({}, unsettled).lost, LostReason::high_residual);
  EXPECT_EQ(judge({}, spread).lost, LostReason::high_residual);
  EXPECT_EQ(judge({}, PoseFit()).lost, LostReason::few_features);
}

TEST(TrackVerdict, ADirectionThatNoPatchTellsIsNoPose) {
  for (int direction = 0; direction < 6; ++direction) {
    PoseFit fit = fitWith(90, 90);
    fit.information(direction, direction) = 0;
    const Verdict verdict = judge({}, fit);
    EXPECT_EQ(verdict.lost, LostReason::high_residual) << direction;
    EXPECT_GT(verdict.covariance(direction, direction), 1e5);
  }
}

TEST(TrackVerdict, PatchesThatAreNotInViewDoNotCount) {
  PoseFit fit = fitWith(40, 40);
  for (std::size_t i = 40; i < 100; ++i)
    for (auto& m : fit.measurements[i]) m.is_visible = false;
  EXPECT_NEAR(judge({}, fit).good_share[0], 1.0, 1e-9);
  for (std::size_t i = 40; i < 100; ++i)
    for (auto& m : fit.measurements[i]) m.is_visible = true, m.expected_ncc = 0.3f;  // too plain to judge
  EXPECT_NEAR(judge({}, fit).good_share[0], 1.0, 1e-9);
}

TEST(TrackVerdict, TheCovarianceIsInCamerasAxes) {
  PoseFit fit = fitWith(90, 90);
  fit.information.diagonal() << 1e8, 1e8, 1e8, 400, 100, 25;  // 0.05, 0.1 and 0.2 mm along Head's axes
  fit.motion.linear() = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Matrix6d covariance = judge({}, fit).covariance;
  EXPECT_NEAR(covariance(3, 3), 0.01, 1e-9) << "Camera's x is Head's y";
  EXPECT_NEAR(covariance(4, 4), 0.0025, 1e-9);
  EXPECT_NEAR(covariance(5, 5), 0.04, 1e-9);
}

TEST(TrackVerdict, RegionsThatPullApartWidenTheCovariance) {
  PoseFit fit = fitWith(90, 90);
  const Matrix6d agreeing = judge({}, fit).covariance;
  fit.pull = 0.25 * fit.information;
  const Matrix6d pulled = judge({}, fit).covariance;
  // Twelve regions, six of which the pose takes: 12 / 6 of a quarter.
  EXPECT_LT((pulled - 1.5 * agreeing).norm(), 1e-9);
}

TEST(TrackVerdict, WhatTheKeyFrameIsUncertainByIsAddedAndMayBeTooMuch) {
  Matrix6d key = Matrix6d::Zero();
  key(3, 3) = 0.1;
  const PoseFit fit = fitWith(90, 90);
  EXPECT_NEAR(judge({}, fit, key).covariance(3, 3), 0.11, 1e-9);
  key(3, 3) = 0.6;  // 0.77 mm: more than 0.6, less than the 1.0 mm that a moment's own key frame may have
  EXPECT_EQ(judge({}, fit, key).lost, LostReason::high_residual);
  EXPECT_TRUE(judge({}, fit, key, true).isTracked());
}

PoseFit distances(float left, float right) {
  PoseFit fit;
  PatchMeasurement l, r;
  l.is_visible = r.is_visible = true, l.distance = left, r.distance = right;
  fit.measurements = {{l, r}};
  return fit;
}

double weightAfter(double seconds, float distance, double since_s = 1.0 / 60) {
  PatchWeights weights(1);
  for (int i = 0; i < int(std::lround(seconds / since_s)); ++i)
    weights.learn(distances(distance, 0), since_s);
  return double(weights.weights()[0]);
}

TEST(PatchWeights, SkinThatKeepsMovingLosesWeightAndNoiseDoesNot) {
  EXPECT_EQ(weightAfter(10, 1.9f), 1.0) << "within two standard deviations";
  EXPECT_NEAR(weightAfter(10, 4.0f), 0.25, 0.001) << "4 / (4 + 16 - 4)";
  const double by_time = 12 * (1 - std::exp(-1.0));  // after the time constant of 0.7 s
  EXPECT_NEAR(weightAfter(0.7, 4.0f), 4 / (4 + by_time), 0.005);
  EXPECT_NEAR(weightAfter(0.7, 4.0f, 0.05), weightAfter(0.7, 4.0f), 0.005) << "whatever the frame rate";
}

TEST(PatchWeights, OneBadFrameCostsLittle) {
  PatchWeights weights(1);
  weights.learn(distances(1e4f, 1e4f), 1.0 / 60);
  EXPECT_GT(weights.weights()[0], 0.75f);
  PatchWeights after_a_pause(1);
  after_a_pause.learn(distances(1e4f, 1e4f), 30.0);  // limited to a tenth of a second
  EXPECT_GT(after_a_pause.weights()[0], 0.3f);
}

TEST(PatchWeights, WhatIsNotSeenKeepsItsWeightAndForgettingGivesItBack) {
  PatchWeights weights(1);
  for (int i = 0; i < 60; ++i) weights.learn(distances(5, 0), 1.0 / 60);
  const float before = weights.weights()[0];
  ASSERT_LT(before, 0.5f);
  PoseFit hidden = distances(0, 0);
  for (auto& m : hidden.measurements[0]) m.is_visible = false;
  for (int i = 0; i < 60; ++i) weights.learn(hidden, 1.0 / 60);
  EXPECT_EQ(weights.weights()[0], before);
  weights.forget();
  EXPECT_EQ(weights.weights()[0], 1.0f);
}

/// Patch 0 amid a grid of neighbours, 8 px apart, in light that changes by the share `slope` a pixel.
struct LitFace {
  std::vector<Neighbour> neighbours;
  PatchMeasurements measurements;
};
LitFace litFace(const Eigen::Vector2f& slope, int half = 5) {
  LitFace face;
  for (int v = -half; v <= half; ++v)
    for (int u = -half; u <= half; ++u) {
      PatchMeasurement m = seen(true);
      m.brightness = 0.8f * (1 + slope.dot(Eigen::Vector2f(8.f * float(u), 8.f * float(v))));
      face.neighbours.push_back({int(face.measurements.size()) + 1, 8.f * float(u), 8.f * float(v)});
      face.measurements.push_back({m, m});
    }
  PatchMeasurement own = seen(true);
  own.brightness = 0.8f;
  face.measurements.insert(face.measurements.begin(), {own, own});
  return face;
}

TEST(LightSlope, IsThatOfTheLight) {
  const Eigen::Vector2f slope(0.003f, -0.002f);
  const LitFace face = litFace(slope);
  for (const int camera : {0, 1})
    EXPECT_LT((lightSlope(face.neighbours, face.measurements, 0, camera) - slope).norm(), 5e-5f);
}

TEST(LightSlope, AShadowsEdgeAndHiddenNeighboursDoNotTurnIt) {
  const Eigen::Vector2f slope(0.003f, -0.002f);
  LitFace face = litFace(slope);
  for (std::size_t i = 1; i < face.measurements.size(); i += 3) face.measurements[i][0].brightness = 0.3f;
  for (std::size_t i = 2; i < face.measurements.size(); i += 3) {
    face.measurements[i][0].brightness = 0.9f;
    face.measurements[i][0].is_visible = false;
  }
  EXPECT_LT((lightSlope(face.neighbours, face.measurements, 0, 0) - slope).norm(), 1e-4f);
}

TEST(LightSlope, FewNeighboursOrADarkPatchSayNothing) {
  LitFace few = litFace({0.01f, 0}, 0), dark = litFace({0.01f, 0});
  EXPECT_TRUE(lightSlope(few.neighbours, few.measurements, 0, 0).isZero(0));
  dark.measurements[0][0].brightness = 0.04f;
  EXPECT_TRUE(lightSlope(dark.neighbours, dark.measurements, 0, 0).isZero(0));
}

}  // namespace
}  // namespace facenav::head_tracking
