#include "facenav/measured_face/shared_depth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "facenav/stereo/shared_error.h"
#include "support/stereo_rigs.h"

namespace facenav::steps {
namespace {

PointCloud<Camera> faceAt(double z_mm) {
  PointCloud<Camera> face;
  for (int i = -5; i <= 5; ++i) face.points_mm.push_back({8.0 * i, 3.0 * i, z_mm});
  return face;
}

/// Calibration in which only this parameter has an error.
cameras::StereoRig knownBut(int parameter, double sigma) {
  cameras::StereoRig rig = facenav::testing::convergingRig();
  const int n = 2 * (4 + 5) + 6;
  rig.covariance = cv::Mat::zeros(n, n, CV_64F);
  rig.covariance.at<double>(parameter, parameter) = sigma * sigma;
  return rig;
}

TEST(SharedDepth, WithoutACovarianceIsWhatAGoodCalibrationLeaves) {
  const auto rig = facenav::testing::convergingRig();
  EXPECT_NEAR(measured_face::sharedDepthSigma_mm(rig, faceAt(600)), 0.02 * 600 * 600 / (800 * 120.0), 1e-3);
  EXPECT_EQ(measured_face::sharedDepthSigma_mm(rig, {}), 0.0);
}

TEST(SharedDepth, FollowsTheCalibrationsOwnCovariance) {
  const auto face = faceAt(600);
  const double known_mm = measured_face::sharedDepthSigma_mm(knownBut(0, 0.0), face);
  EXPECT_NEAR(known_mm, 0.01 * 600 * 600 / (800 * 120.0), 0.005) << "only matching is left";
  // The model assumes that a calibration's true errors are 1.5 times the given ones (RigUncertainty). A given
  // error of 0.2 mm for a baseline of 120 mm thus gives 1.5 mm at 600 mm; one of 0.1 px for the right
  // principal point gives 0.15 px.
  constexpr int kShiftX = 2 * (4 + 5) + 3, kRightCentreX = 4 + 5 + 2;
  EXPECT_NEAR(measured_face::sharedDepthSigma_mm(knownBut(kShiftX, 0.2), face), 1.5, 0.1);
  EXPECT_NEAR(measured_face::sharedDepthSigma_mm(knownBut(kRightCentreX, 0.1), face),
              0.15 * 600 * 600 / (800 * 120.0), 0.03);
}

TEST(FaceErrorOf, GrowsWithWhatTheCloudStatesAndHoldsTheCalibration) {
  const auto rig = facenav::testing::convergingRig();
  stereo::FaceCloud face;
  face.cloud = faceAt(600);
  face.sigma_mm.assign(face.cloud.size(), 0.0f);
  const auto exact = measured_face::faceErrorOf(rig, face);
  EXPECT_EQ(exact.sight.sigma_mm, 0.0);
  EXPECT_DOUBLE_EQ(exact.whole_mm, measured_face::sharedDepthSigma_mm(rig, face.cloud));
  const stereo::SharedError shared;
  face.sigma_mm.assign(face.cloud.size(), 0.4f);
  const auto noisy = measured_face::faceErrorOf(rig, face);
  EXPECT_NEAR(noisy.sight.sigma_mm, shared.smooth * 0.4, 1e-6);
  EXPECT_NEAR(noisy.whole_mm, std::hypot(exact.whole_mm, shared.whole * 0.4), 1e-6);
  EXPECT_EQ(noisy.sight.reach_mm, shared.reach_mm);
}

}  // namespace
}  // namespace facenav::steps
