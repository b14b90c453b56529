#include "facenav/casefile/session_track.h"

#include <gmock/gmock.h>

#include <fstream>

#include "facenav/casefile/poses_csv.h"
#include "facenav/core/error.h"
#include "facenav/guidance/guidance_csv.h"
#include "made_pulse.h"
#include "support/test_data.h"

namespace facenav::casefile {
namespace {

using ::testing::HasSubstr;

class SessionTrackTest : public ::testing::Test {
 protected:
  /// Ten frames of 20 ms; the face is lost in frames 4 and 5, the coil in frame 7.
  SessionTrackTest() {
    const auto pulse = madePulse(1, 1.5);
    std::vector<PoseRow> poses;
    std::vector<guidance::GuidanceRow> guided;
    for (int n = 0; n < 10; ++n) {
      const double t_s = 100.0 + 0.02 * n;
      const bool has_face = n < 4 || n > 5, has_coil = n != 7;
      using Face = Tracked<RigidTransform<Camera, Mri>>;
      using AtCoil = Tracked<RigidTransform<Camera, Coil>>;
      const Face head = has_face ? Face(*pulse.camera_T_mri, 0.9) : Face(Lost{LostReason::no_face});
      const AtCoil coil = has_coil ? AtCoil(*pulse.camera_T_coil, 0.8) : AtCoil(Lost{LostReason::no_marker});
      poses.push_back(poseRow(n, t_s, PoseObject::head, head));
      poses.push_back(poseRow(n, t_s, PoseObject::coil, coil));
      guided.push_back({n, t_s, "M1, \"hand\"", guidance::evaluate(*pulse.target, head, coil, {}, 0.8)});
    }
    writePoses(poses, poses_);
    guidance::writeGuidanceCsv(guided, guidance_);
  }
  SessionTrack read() const { return readSessionTrack(poses_, guidance_); }
  testing::TemporaryFolder folder_;
  std::filesystem::path poses_ = folder_.path() / "poses.csv", guidance_ = folder_.path() / "guidance.csv";
};

TEST_F(SessionTrackTest, PosesAndGuidanceAreThoseOfTheFiles) {
  const auto track = read();
  ASSERT_EQ(track.moments.size(), 10u);
  EXPECT_NEAR(track.duration_s(), 0.18, 1e-9);
  const auto pulse = madePulse(1, 1.5);
  const auto camera_T_mri = track.moments[2].camera_T_mri();
  ASSERT_TRUE(camera_T_mri);
  EXPECT_TRUE(camera_T_mri->isometry().isApprox(pulse.camera_T_mri->isometry(), 1e-6));
  EXPECT_TRUE(track.moments[2].camera_T_coil()->isometry().isApprox(pulse.camera_T_coil->isometry(), 1e-6));
  EXPECT_EQ(track.word(track.moments[2].target), "M1, \"hand\"");
  EXPECT_EQ(track.word(track.moments[2].state), "on_target");
  EXPECT_NEAR(track.moments[2].guidance.distance_mm, 1.5, 1e-3);
  EXPECT_NEAR(track.moments[2].guidance.predicted_error_mm, 0.8, 1e-3);
  EXPECT_TRUE(track.is_in_mri && track.is_coil);
  EXPECT_TRUE(track.problems.empty());
}

TEST_F(SessionTrackTest, ALostFrameHasNoPoseAndSaysWhy) {
  const auto track = read();
  EXPECT_FALSE(track.moments[4].camera_T_mri());
  EXPECT_EQ(track.word(track.moments[4].head_reason), "no_face");
  EXPECT_FALSE(track.moments[4].has_guidance) << "no value of the frame before";
  EXPECT_EQ(track.word(track.moments[4].state), "lost");
  EXPECT_TRUE(track.moments[7].camera_T_mri());
  EXPECT_FALSE(track.moments[7].camera_T_coil());
  EXPECT_EQ(track.word(track.moments[7].coil_reason), "no_marker");
}

TEST_F(SessionTrackTest, AMomentIsFoundByItsTime) {
  const auto track = read();
  EXPECT_EQ(track.at(0), 0u);
  EXPECT_EQ(track.at(100.0), 0u);
  EXPECT_EQ(track.at(100.0599), 2u);
  EXPECT_EQ(track.at(100.0601), 3u);
  EXPECT_EQ(track.at(1e9), 9u);
}

TEST_F(SessionTrackTest, ATornLineAndDamagedOnesAreLeftOutAndCounted) {
  std::ofstream(poses_, std::ios::app) << "10,100.2,head,tracked,1,2,3,9,0,0,0,1,,mri,\n"  // no rotation
                                       << "11,99.0,head,lost,,,,,,,,0,no_face,mri,\n"      // time goes back
                                       << "12,100.24,head,tra";
  const auto track = read();
  EXPECT_EQ(track.moments.size(), 10u);
  ASSERT_EQ(track.problems.size(), 1u);
  EXPECT_THAT(track.problems[0], HasSubstr("3 lines are damaged"));
}

TEST_F(SessionTrackTest, PosesThatAreNotThoseOfTheMriAreKnownAsSuch) {
  std::ofstream(poses_, std::ios::app) << "10,100.2,head,lost,,,,,,,,0,no_face,head,\n"
                                       << "10,100.2,coil,lost,,,,,,,,0,no_marker,marker,\n";
  EXPECT_FALSE(read().is_in_mri);
  EXPECT_FALSE(read().is_coil);
}

TEST_F(SessionTrackTest, WithoutPosesThereIsNothingToReplayAndWithoutGuidanceThereIs) {
  std::filesystem::remove(guidance_);
  EXPECT_FALSE(read().moments[2].has_guidance);
  std::filesystem::remove(poses_);
  EXPECT_THROW(read(), Error);
  std::ofstream(poses_) << "frame,t_s\n";
  EXPECT_THROW(read(), Error);
}

}  // namespace
}  // namespace facenav::casefile
