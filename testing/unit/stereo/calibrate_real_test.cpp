// Real data: the 13 chessboard pairs of Debian's opencv-doc.

#include <gtest/gtest.h>

#include <cstdio>
#include <opencv2/imgcodecs.hpp>

#include "facenav/stereo/calibrate.h"
#include "support/test_data.h"

using namespace facenav;
using namespace facenav::stereo;

TEST(CalibrateRealData, ThirteenOpenCvPairsReachAQuarterPixel) {
  const auto folder = facenav::testing::openCvSamples();
  FACENAV_NEEDS(folder / "left01.jpg");
  std::vector<CalibrationPair> pairs;
  for (int i = 1; i <= 14; ++i) {
    char name[16];
    std::snprintf(name, sizeof name, "%02d.jpg", i);
    if (!std::filesystem::exists(folder / (std::string("left") + name))) continue;  // there is no 10
    pairs.push_back({name, cv::imread(folder / (std::string("left") + name), cv::IMREAD_GRAYSCALE),
                     cv::imread(folder / (std::string("right") + name), cv::IMREAD_GRAYSCALE)});
  }
  ASSERT_EQ(pairs.size(), 13u);
  TaskMonitor monitor;
  const Calibration result = calibrate(pairs, {9, 6, 25.0}, monitor);
  EXPECT_EQ(result.usedViews(), 13);
  EXPECT_LE(result.rms_px, 0.25);
  EXPECT_LE(result.held_out_rms_px, 0.25);
  EXPECT_NEAR(result.rig.left.k(0, 0), 534, 5);  // as intrinsics.yml of the same package says, 5.36e2
  EXPECT_GT(result.rig.right_T_left.inverse().translation_mm().x(), 0);
}
