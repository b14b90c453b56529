#include <gtest/gtest.h>

#include <fstream>

#include "facenav/capture/recording.h"
#include "facenav/core/error.h"
#include "support/matchers.h"
#include "support/recordings.h"
#include "support/test_data.h"

using namespace facenav;
using namespace facenav::capture;
namespace fs = std::filesystem;
namespace support = facenav::testing;
using support::TemporaryFolder;

TEST(RecordingWriter, KeepsWhenTheRightPictureWasTaken) {
  TemporaryFolder folder;
  {
    RecordingWriter writer(folder.path() / "rec", support::smallRig());
    auto frame = support::noiseFrame(0, 0.5);
    frame.right_late_s = -0.009;
    writer.add(frame);
    writer.add(support::noiseFrame(1, 0.6));
    writer.close();
  }
  const auto source = makeSource(openRecording(folder.path() / "rec"));
  EXPECT_NEAR(source->next()->right_late_s.value(), -0.009, 1e-8);
  EXPECT_FALSE(source->next()->right_late_s);
}

TEST(RecordingWriter, WhatIsWrittenIsReadBack) {
  TemporaryFolder folder;
  support::writeSmallRecording(folder.path() / "rec", 4, 17);
  const Recording recording = openRecording(folder.path() / "rec");
  EXPECT_EQ(recording.frame_count, 4);
  EXPECT_TRUE(recording.has_timestamps);
  EXPECT_NEAR(recording.frames_per_s, 50.0, 1e-9);
  ASSERT_TRUE(recording.capture);
  EXPECT_EQ(cv::norm(recording.capture->pattern.right, support::noiseFrame(500, 0).right), 0);
  EXPECT_EQ(cv::norm(recording.capture->plain.left, support::noiseFrame(600, 0).left), 0);
  EXPECT_THAT(recording.rig.right_T_left, support::PoseNear(support::smallRig().right_T_left, 1e-9, 1e-9));
  const auto source = makeSource(recording);
  for (int i = 0; i < 4; ++i) {
    const auto frame = source->next(),
               expected = std::make_shared<const cameras::StereoFrame>(support::noiseFrame(17 + i, 0.02 * i));
    EXPECT_EQ(frame->number, expected->number);
    EXPECT_NEAR(frame->captured.s, expected->captured.s, 1e-9);
    EXPECT_EQ(cv::norm(frame->left, expected->left), 0);
    EXPECT_EQ(cv::norm(frame->right, expected->right), 0);
  }
}

TEST(RecordingWriter, LeavesNothingWhenNotClosed) {
  TemporaryFolder folder;
  {
    RecordingWriter writer(folder.path() / "rec", support::smallRig());
    writer.add(support::noiseFrame(0, 0));
    EXPECT_TRUE(fs::exists(writer.temporaryFolder() / "left" / "000000.png"));
    EXPECT_FALSE(fs::exists(folder.path() / "rec"));
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(RecordingWriter, NeverTouchesAFolderThatHoldsSomething) {
  TemporaryFolder folder;
  fs::create_directory(folder.path() / "rec");
  std::ofstream(folder.path() / "rec" / "notes.txt") << "mine";
  EXPECT_THROW(RecordingWriter(folder.path() / "rec", support::smallRig()), Error);
  EXPECT_TRUE(fs::exists(folder.path() / "rec" / "notes.txt"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST(RecordingWriter, TruthSurvives) {
  TemporaryFolder folder;
  Eigen::Isometry3d head = Eigen::Isometry3d::Identity();
  head.linear() = expRotation({0.3, -2.2, 0.7});
  head.translation() = Eigen::Vector3d(12.25, -33.5, 601.125);
  {
    RecordingWriter writer(folder.path() / "rec/", support::smallRig());
    writer.add(support::noiseFrame(3, 0.5));
    writer.addTruth(3, head, std::nullopt);
    writer.close();
  }
  const auto truth = readTruth(folder.path() / "rec" / "truth" / "head.csv");
  ASSERT_EQ(truth.size(), 1u);
  EXPECT_LT((truth.at(3).matrix() - head.matrix()).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_FALSE(fs::exists(folder.path() / "rec" / "truth" / "coil.csv"));
}
