#include "facenav/casefile/face_looks.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "facenav/core/error.h"
#include "support/matchers.h"
#include "support/stereo_rigs.h"
#include "support/test_data.h"

namespace facenav::casefile {
namespace {

using facenav::testing::PoseNear;
using facenav::testing::TemporaryFolder;

StoredKeyFrame look(int number) {
  StoredKeyFrame made;
  made.rig = facenav::testing::convergingRig();
  made.frame.left = cv::Mat(made.rig.height_px, made.rig.width_px, CV_8UC1, cv::Scalar(10 + number));
  made.frame.right = made.frame.left + 1;
  made.camera_T_mri = RigidTransform<Camera, Mri>(
      Eigen::Quaterniond(Eigen::AngleAxisd(0.1 * number + 2, Eigen::Vector3d(1, 2, 3).normalized())),
      {1.0 * number, -20, 600});
  made.covariance.setRandom();
  made.captured_utc = "20261123T08000" + std::to_string(number) + "Z";
  return made;
}

TEST(FaceLooks, ComeBackAsTheyWereKept) {
  const TemporaryFolder folder;
  EXPECT_TRUE(readKeyFrames(folder.path()).empty());
  const StoredKeyFrame kept = look(1);
  addKeyFrames(folder.path(), {kept});
  const auto key_frames = readKeyFrames(folder.path());
  ASSERT_EQ(key_frames.size(), 1u);
  EXPECT_THAT(key_frames[0].camera_T_mri, PoseNear(kept.camera_T_mri, 1e-9, 1e-9));
  EXPECT_LT((key_frames[0].covariance - kept.covariance).norm(), 1e-12);
  EXPECT_EQ(cv::norm(key_frames[0].frame.left, kept.frame.left, cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(key_frames[0].frame.right, kept.frame.right, cv::NORM_INF), 0);
  EXPECT_EQ(key_frames[0].captured_utc, kept.captured_utc);
  EXPECT_NEAR(key_frames[0].rig.baseline_mm(), kept.rig.baseline_mm(), 1e-9);
}

TEST(FaceLooks, TheOldestGoWhenThereAreTooMany) {
  const TemporaryFolder folder;
  for (int i = 0; i < 8; ++i) addKeyFrames(folder.path(), {look(i)});
  const auto key_frames = readKeyFrames(folder.path());
  ASSERT_EQ(key_frames.size(), kMostLooks);
  EXPECT_EQ(key_frames.front().captured_utc, look(2).captured_utc);
  EXPECT_EQ(key_frames.back().frame.left.at<unsigned char>(0, 0), 17);
}

TEST(FaceLooks, AreForTheUserAlone) {
  const TemporaryFolder folder;
  addKeyFrames(folder.path(), {look(1)});
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
    struct stat status {};
    ASSERT_EQ(::stat(entry.path().c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, entry.is_directory() ? 0700u : 0600u) << entry.path();
  }
}

TEST(FaceLooks, APictureThatIsMissingIsNamed) {
  const TemporaryFolder folder;
  addKeyFrames(folder.path(), {look(1)});
  std::filesystem::remove(folder.path() / "face_looks" / "0_right.png");
  try {
    readKeyFrames(folder.path());
    FAIL() << "read";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("0_right.png"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace facenav::casefile
