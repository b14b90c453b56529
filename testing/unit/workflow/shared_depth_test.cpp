#include "facenav/workflow/shared_depth.h"

#include <gtest/gtest.h>

#include "support/stereo_rigs.h"

namespace facenav::workflow {
namespace {

PointCloud<Camera> faceAt(double z_mm) {
  PointCloud<Camera> face;
  for (int i = -5; i <= 5; ++i) face.points_mm.push_back({8.0 * i, 3.0 * i, z_mm});
  return face;
}

/// A calibration that knows all but this one parameter.
cameras::StereoRig knownBut(int parameter, double sigma) {
  cameras::StereoRig rig = facenav::testing::convergingRig();
  const int n = 2 * (4 + 5) + 6;
  rig.covariance = cv::Mat::zeros(n, n, CV_64F);
  rig.covariance.at<double>(parameter, parameter) = sigma * sigma;
  return rig;
}

TEST(SharedDepth, WithoutACovarianceIsWhatAGoodCalibrationLeaves) {
  const auto rig = facenav::testing::convergingRig();
  EXPECT_NEAR(sharedDepthSigma_mm(rig, faceAt(600)), 0.02 * 600 * 600 / (800 * 120.0), 1e-3);
  EXPECT_EQ(sharedDepthSigma_mm(rig, {}), 0.0);
}

TEST(SharedDepth, FollowsTheCalibrationsOwnCovariance) {
  const auto face = faceAt(600);
  const double known_mm = sharedDepthSigma_mm(knownBut(0, 0.0), face);
  EXPECT_NEAR(known_mm, 0.01 * 600 * 600 / (800 * 120.0), 0.005) << "only matching is left";
  // Calibrations are off by 1.5 of the errors that they state (RigUncertainty). A baseline that is stated to
  // 0.2 mm of 120 then makes 600 mm uncertain by 1.5 mm; a right principal point to 0.1 px, by 0.15 px.
  constexpr int kShiftX = 2 * (4 + 5) + 3, kRightCentreX = 4 + 5 + 2;
  EXPECT_NEAR(sharedDepthSigma_mm(knownBut(kShiftX, 0.2), face), 1.5, 0.1);
  EXPECT_NEAR(sharedDepthSigma_mm(knownBut(kRightCentreX, 0.1), face), 0.15 * 600 * 600 / (800 * 120.0),
              0.03);
}

}  // namespace
}  // namespace facenav::workflow
