#include "facenav/review/session_replay.h"

#include <gmock/gmock.h>

#include <fstream>

#include "facenav/casefile/poses_csv.h"
#include "facenav/core/error.h"
#include "support/recordings.h"
#include "support/test_data.h"
#include "unit/case/casefile/made_pulse.h"

namespace facenav::steps {
namespace {

using ::testing::HasSubstr;

class SessionReplayTest : public ::testing::Test {
 protected:
  /// Writes six frames, 20 ms apart from `first_s` on; the coil is lost in the last one.
  void writeSession(double first_s = 300.0) {
    std::vector<casefile::PoseRow> poses;
    const auto pulse = casefile::madePulse(1);
    for (int n = 0; n < 6; ++n) {
      using AtCoil = Tracked<RigidTransform<Camera, Coil>>;
      poses.push_back(casefile::poseRow(n, first_s + 0.02 * n, casefile::PoseObject::head,
                                        Tracked<RigidTransform<Camera, Mri>>(*pulse.camera_T_mri, 0.9)));
      poses.push_back(
          casefile::poseRow(n, first_s + 0.02 * n, casefile::PoseObject::coil,
                            n < 5 ? AtCoil(*pulse.camera_T_coil, 0.9) : AtCoil(Lost{LostReason::no_marker})));
    }
    casefile::writePoses(poses, session_ / "poses.csv");
  }
  void SetUp() override {
    std::filesystem::create_directories(session_);
    writeSession();
  }
  testing::TemporaryFolder folder_;
  std::filesystem::path session_ = folder_.path() / "session";
};

TEST_F(SessionReplayTest, PicturesOfTheKeptRecordingAreFoundInAnyOrder) {
  testing::writeSmallRecording(session_ / "recording", 6);
  const auto replay = openReplay(session_);
  ASSERT_TRUE(replay.pictures) << replay.pictures_words;
  for (const int n : {4, 1, 5, 0}) {
    const auto frame = replay.pictures->frame(n);
    ASSERT_TRUE(frame) << n;
    EXPECT_EQ(frame->number, n);
    EXPECT_EQ(cv::norm(frame->left, testing::noiseImage(2 * n), cv::NORM_INF), 0) << n;
    EXPECT_EQ(cv::norm(frame->right, testing::noiseImage(2 * n + 1), cv::NORM_INF), 0) << n;
  }
  EXPECT_FALSE(replay.pictures->frame(6));
}

TEST_F(SessionReplayTest, WithoutARecordingTheSessionIsReplayedAndThisIsSaid) {
  const auto replay = openReplay(session_);
  EXPECT_EQ(replay.track.moments.size(), 6u);
  EXPECT_FALSE(replay.pictures);
  EXPECT_THAT(replay.pictures_words, HasSubstr("no pictures were kept"));
}

TEST_F(SessionReplayTest, PicturesOfAnotherRecordingAreRefused) {
  const auto track = openReplay(session_).track;
  const auto other = folder_.path() / "other";
  testing::writeSmallRecording(other, 6, 100);
  EXPECT_THROW(openPictures(other, track), Error) << "other frames";
  const auto slower = folder_.path() / "slower";
  testing::writeSmallRecording(slower, 6);
  {
    std::ofstream csv(slower / "timestamps.csv");
    csv << "frame,t_s\n";
    for (int n = 0; n < 6; ++n) csv << n << "," << 0.025 * n << "\n";
  }
  EXPECT_THROW(openPictures(slower, track), Error) << "other times";
}

TEST_F(SessionReplayTest, ALossIsSaidInWords) {
  const auto track = openReplay(session_).track;
  EXPECT_EQ(lossAt(track, track.moments[0]), "");
  EXPECT_EQ(lossAt(track, track.moments[5]), "coil lost: no_marker");
  auto not_aligned = track;
  not_aligned.is_in_mri = false;
  EXPECT_THAT(lossAt(not_aligned, track.moments[0]), HasSubstr("not aligned"));
}

TEST_F(SessionReplayTest, WithoutFramesThereIsNothingToReplay) {
  std::ofstream(session_ / "poses.csv") << casefile::posesCsvHeader();
  EXPECT_THROW(openReplay(session_), Error);
}

}  // namespace
}  // namespace facenav::steps
