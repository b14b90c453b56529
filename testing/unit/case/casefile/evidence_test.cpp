#include "facenav/casefile/evidence.h"

#include <gtest/gtest.h>

#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "made_pulse.h"
#include "support/test_data.h"

namespace facenav::casefile {
namespace {

namespace fs = std::filesystem;

cameras::StereoRig evidenceRig() {
  cameras::StereoRig rig;
  rig.width_px = 64, rig.height_px = 48;
  rig.left.k = rig.right.k = cv::Matx33d(80, 0, 32, 0, 80, 24, 0, 0, 1);
  rig.right_T_left = RigidTransform<RightCamera, Camera>(Eigen::Quaterniond::Identity(), {-120, 0, 0});
  return rig;
}

cameras::StereoFrame evidenceFrameOf(std::int64_t number) {
  cameras::StereoFrame frame;
  frame.left = cv::Mat(48, 64, CV_8UC1, cv::Scalar(double(number)));
  frame.right = cv::Mat(48, 64, CV_8UC1, cv::Scalar(double(number + 100)));
  frame.number = number;
  frame.captured = {0.1 * double(number)};
  return frame;
}

TEST(Evidence, BothPicturesAreKeptOnceAndPrivate) {
  const testing::TemporaryFolder folder;
  EvidenceFolder evidence(folder.path(), evidenceRig());
  EXPECT_FALSE(fs::exists(evidenceFolder(folder.path()))) << "nothing before the first pulse";
  EXPECT_TRUE(evidence.keep(evidenceFrameOf(7)));
  EXPECT_FALSE(evidence.keep(evidenceFrameOf(7))) << "several pulses share a frame";
  EXPECT_TRUE(evidence.keep(evidenceFrameOf(9)));
  EXPECT_FALSE(evidence.keep(evidenceFrameOf(8))) << "frames of a recording rise";
  const fs::path at = evidenceFolder(folder.path());
  EXPECT_NEAR(cv::mean(cv::imread((at / "right/000009.jpg").string(), cv::IMREAD_GRAYSCALE))[0], 109, 1);
  EXPECT_EQ(readWholeFile(at / "timestamps.csv"), "frame,t_s\n7,0.700000000\n9,0.900000000\n");
  for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
    EXPECT_EQ(entry.status().permissions() & (fs::perms::group_all | fs::perms::others_all), fs::perms::none)
        << entry.path();
}

TEST(Evidence, APulseHasThePicturesOfTheFrameNearestToIt) {
  const testing::TemporaryFolder folder;
  EvidenceFolder evidence(folder.path(), evidenceRig());
  evidence.keep(evidenceFrameOf(7));
  evidence.keep(evidenceFrameOf(8));
  Pulse pulse = madePulse(1);  // frames 7 and 8, a quarter of the way
  EXPECT_EQ(evidenceFrame(folder.path(), pulse), 7);
  pulse.fraction = 0.75;
  EXPECT_EQ(evidenceFrame(folder.path(), pulse), 8);
  EXPECT_FALSE(evidenceFrame(folder.path(), madePulse(2)));
  pulse.frames.reset();
  EXPECT_FALSE(evidenceFrame(folder.path(), pulse));
}

TEST(Evidence, WhatAKillLeftBehindIsMendedAndTheFolderGoesOn) {
  const testing::TemporaryFolder folder;
  const fs::path at = evidenceFolder(folder.path());
  {
    EvidenceFolder evidence(folder.path(), evidenceRig());
    evidence.keep(evidenceFrameOf(7));
    evidence.keep(evidenceFrameOf(9));
  }
  fs::remove(at / "right/000009.jpg");
  std::ofstream(at / "timestamps.csv", std::ios::app) << "11,1.";
  mendEvidence(folder.path());
  EXPECT_FALSE(fs::exists(at / "left/000009.jpg"));
  EXPECT_EQ(readWholeFile(at / "timestamps.csv"), "frame,t_s\n7,0.700000000\n9,0.900000000\n");
  EvidenceFolder again(folder.path(), evidenceRig());
  EXPECT_TRUE(again.keep(evidenceFrameOf(12)));
  EXPECT_TRUE(fs::exists(at / "left/000012.jpg"));
}

TEST(Evidence, AFolderThatCannotBeMadeIsAnErrorAndLaterPicturesAreKept) {
  const testing::TemporaryFolder folder;
  const fs::path session = folder.path() / "session";
  EvidenceFolder evidence(session, evidenceRig());
  EXPECT_THROW(evidence.keep(evidenceFrameOf(7)), Error) << "the session's folder is gone";
  fs::create_directory(session);
  EXPECT_TRUE(evidence.keep(evidenceFrameOf(8)));
}

}  // namespace
}  // namespace facenav::casefile
