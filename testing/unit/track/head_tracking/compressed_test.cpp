// A face that returns compressed, rotated and with its jaw down: it is found, distinguished from another
// person's, and not shown when the two images are out of step.

#include "head_scene.h"

namespace facenav {
namespace {

using namespace head_tracking::testing;

class CompressedFace : public HeadTrackers {
 protected:
  static cameras::StereoFrame compressed(cameras::StereoFrame frame) {
    for (cv::Mat* picture : {&frame.left, &frame.right}) {
      std::vector<unsigned char> bytes;
      cv::imencode(".jpg", *picture, bytes, {cv::IMWRITE_JPEG_QUALITY, 25});
      *picture = cv::imdecode(bytes, cv::IMREAD_GRAYSCALE);
    }
    return frame;
  }
  static SyntheticView later(int frame, double yaw_deg) {
    SyntheticView view = turnedView(frame, yaw_deg);
    view.jaw_drop_mm = 10.0, view.noise_grey = 1.0;
    view.time_s += 2.0;
    return view;
  }
  std::unique_ptr<head_tracking::HeadTracker> started(
      head_tracking::Pace pace = head_tracking::Pace::patient,
      const std::vector<head_tracking::FaceKeyFrame>& key_frames = {}) const {
    auto tracker = head_tracking::makeModelHeadTracker(detector());
    head_tracking::HeadReference reference = face_->reference(rig_, true);
    reference.frame = compressed(reference.frame);
    reference.key_frames = key_frames;
    tracker->start(rig_, reference, pace);
    for (int i = 0; i < 3; ++i)
      EXPECT_TRUE(tracker->track(compressed(face_->render(rig_, stillView(i)))).isTracked()) << i;
    return tracker;
  }
};

TEST_F(CompressedFace, IsFoundAgainTurnedAndWithItsJawDown) {
  const auto tracker = started();
  for (int i = 0; i < 3; ++i) {
    const SyntheticView view = later(i, 4.0);
    const auto pose = tracker->track(compressed(face_->render(rig_, view)));
    ASSERT_TRUE(pose.isTracked()) << i << ": " << wordOf(pose);
    EXPECT_LT(errorOf(*pose, view).at_point_mm, 1.5);
    EXPECT_LT(errorOf(*pose, view).rotation_rad / kRadPerDeg, 0.5);
  }
}

/// On a slow machine the answer is late, but it still gives a start.
TEST_F(CompressedFace, IsFoundAgainByAnAnswerThatComesLate) {
  const auto tracker = started(head_tracking::Pace::as_live);
  std::string word = "never asked";
  for (int i = 0; i < 4 && !word.empty(); ++i) {
    SyntheticView view = later(i, 4.0);
    view.time_s = 2.0 + 0.6 * i;
    word = wordOf(tracker->track(compressed(face_->render(rig_, view))));
  }
  EXPECT_EQ(word, "");
}

/// The patches find the face one frame after the recovery was requested. Their pose is doubtful and not
/// shown, so the answer is still used.
TEST_F(CompressedFace, ThatIsBackIsShownByTheFirstAnswer) {
  const auto tracker = started(head_tracking::Pace::as_live);
  double found_s = 1e9;
  for (int i = 0; i < 16 && found_s > 1; ++i) {
    SyntheticView view = later(i, 2.0);
    view.time_s = 2.0 + i / 60.0;
    // The coil has reserved the first frame: no time for a fit in it.
    const FrameWork reserved{i == 0 ? FrameWork::most() : 0};
    if (tracker->track(compressed(face_->render(rig_, view)), {reserved, false})) found_s = view.time_s - 2.0;
  }
  EXPECT_LT(found_s, 0.11);
}

/// Appearance learnt in one session is known in the next.
TEST_F(CompressedFace, IsLearntAndKnownInTheNextSession) {
  const auto first = started();
  SyntheticView smiling = later(0, 14.0);
  smiling.lamp_x = -0.2, smiling.jaw_drop_mm = 18.0;
  ASSERT_TRUE(first->track(compressed(face_->render(rig_, smiling))).isTracked());
  const auto key_frames = first->learntKeyFrames();
  ASSERT_FALSE(key_frames.empty());
  EXPECT_LT(poseError(RigidTransform<Camera, Head>::fromIsometry(key_frames.back().camera_T_head),
                      RigidTransform<Camera, Head>::fromIsometry(smiling.motion), kCortex)
                .at_point_mm,
            1.5);
  EXPECT_EQ(key_frames.back().frame.left.at<unsigned char>(0, 0), 0) << "all but the face is black";
  const auto second = started(head_tracking::Pace::patient, key_frames);
  smiling.seed = 77;
  const auto pose = second->track(compressed(face_->render(rig_, smiling)));
  ASSERT_TRUE(pose.isTracked());
  EXPECT_LT(errorOf(*pose, smiling).at_point_mm, 1.5);
  const SyntheticFace other = SyntheticFace::stranger();
  EXPECT_FALSE(second->track(compressed(other.render(rig_, later(2, 4.0)))).isTracked());
}

/// After an answer was discarded, another request must follow.
TEST_F(CompressedFace, IsAskedAboutAgainAfterWhatWasLearntWasForgotten) {
  const auto tracker = started(head_tracking::Pace::as_live);
  int questions = 0;
  for (int i = 3; i < 55; ++i) {  // the first request was made; its answer has not been read yet
    const auto pose = tracker->track(compressed(face_->render(rig_, stillView(i))), {{}, i == 3});
    EXPECT_TRUE(pose.isTracked()) << i;
    questions += pose.beside_ms > 0;
  }
  EXPECT_EQ(questions, 1) << "one in a second and a half";
}

TEST_F(CompressedFace, OfAnotherPersonIsNeverShown) {
  const auto tracker = started();
  const SyntheticFace other = SyntheticFace::stranger();
  for (int i = 0; i < 3; ++i)
    EXPECT_FALSE(tracker->track(compressed(other.render(rig_, later(i, 4.0)))).isTracked()) << i;
}

/// The picture with nothing but the face's box, grown to half its size on each side.
cv::Mat alone(const cv::Mat& picture, const cv::Rect& face) {
  const cv::Rect grown(face.x - face.width / 2, face.y - face.height / 2, 2 * face.width, 2 * face.height);
  const cv::Rect part = grown & cv::Rect({}, picture.size());
  cv::Mat kept(picture.size(), picture.type(), cv::Scalar(80));
  picture(part).copyTo(kept(part));
  return kept;
}

TEST_F(CompressedFace, OnSidesOfTwoMomentsIsNeverShown) {
  for (const double apart_mm : {0.7, 5.0}) {
    const auto tracker = started();
    for (int i = 0; i < 3; ++i) {
      SyntheticView lower = later(i, 0.0);
      lower.motion.pretranslate(Eigen::Vector3d(0, apart_mm, 0));
      auto frame = compressed(face_->render(rig_, later(i, 0.0)));
      frame.right = compressed(face_->render(rig_, lower)).right;
      // No room is in view that would tell a moved camera from two exposures. The background of these
      // pictures lies at the same pixels in both, as no wall does.
      const auto left = detector()->detect(frame.left), right = detector()->detect(frame.right);
      ASSERT_TRUE(left && right);
      frame.left = alone(frame.left, left->face), frame.right = alone(frame.right, right->face);
      EXPECT_EQ(wordOf(tracker->track(frame)), "cameras_disagree") << apart_mm << " mm, " << i;
    }
  }
}

TEST_F(CompressedFace, ThatIsGoneAfterTwoMomentsIsSaidToBeGone) {
  const auto tracker = started();
  SyntheticView lower = later(0, 0.0);
  lower.motion.pretranslate(Eigen::Vector3d(0, 5, 0));
  auto frame = compressed(face_->render(rig_, later(0, 0.0)));
  frame.right = compressed(face_->render(rig_, lower)).right;
  const std::string first = wordOf(tracker->track(frame));
  ASSERT_TRUE(first == "cameras_disagree" || first == "out_of_step") << first;
  std::string word;
  for (int i = 1; i < 4; ++i) {
    SyntheticView gone = later(i, 0.0);
    gone.motion.pretranslate(Eigen::Vector3d(3000, 0, 0));
    const auto answer = tracker->track(compressed(face_->render(rig_, gone)));
    EXPECT_FALSE(answer.isTracked());
    word = wordOf(answer);
  }
  EXPECT_EQ(word, "not_found");
}

/// Cameras without a trigger see a moving head at two places, which must not end the track permanently.
TEST_F(CompressedFace, WhoComesBackMovingBeforeUntriggeredCamerasIsFound) {
  const auto tracker = started();
  std::string word = "never asked";
  for (int i = 0; i < 8 && !word.empty(); ++i) {
    SyntheticView view = later(i, 4.0), right = view;
    view.motion.pretranslate(Eigen::Vector3d(0, 2.0 * i, 0));         // 60 mm/s
    right.motion.pretranslate(Eigen::Vector3d(0, 2.0 * i + 0.3, 0));  // 5 ms later
    auto frame = compressed(face_->render(rig_, view));
    frame.right = compressed(face_->render(rig_, right)).right;
    word = wordOf(tracker->track(frame));
  }
  EXPECT_EQ(word, "");
}

/// A real person before three real cameras (../shared/data/real_faces), two returns, by two pairs of cameras.
class RealFace : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder() / "person")) GTEST_SKIP() << "no shared data (real_faces)";
  }
  static std::filesystem::path folder() { return facenav::testing::sharedData() / "real_faces"; }
  static cv::Mat picture(char camera, const std::string& moment) {
    return cv::imread((folder() / "person" / (std::string(1, camera) + "_" + moment + ".jpg")).string(),
                      cv::IMREAD_GRAYSCALE);
  }
  static head_tracking::HeadResult seen(const std::string& name, const std::string& from,
                                        const std::string& left, const std::string& right) {
    const auto rig = cameras::readRig(folder() / (name + "_stereo.yml"));
    const auto tracker = head_tracking::makeModelHeadTracker(detector());
    head_tracking::HeadReference reference;
    reference.frame.left = picture(name[0], from), reference.frame.right = picture(name[1], from);
    tracker->start(rig, reference, head_tracking::Pace::patient);
    cameras::StereoFrame frame;
    frame.left = picture(name[0], left), frame.right = picture(name[1], right);
    frame.captured.s = 2.0;
    return tracker->track(frame);
  }
};

TEST_F(RealFace, IsFoundAgainAtAnotherMomentAndTwoPairsOfCamerasAgree) {
  const auto lm = cameras::readRig(folder() / "lm_stereo.yml").right_T_left.isometry();
  const auto left = seen("lm", "418", "1252", "1252"), right = seen("mr", "418", "1252", "1252");
  ASSERT_TRUE(left.isTracked()) << wordOf(left);
  ASSERT_TRUE(right.isTracked()) << wordOf(right);
  const Eigen::Isometry3d a = lm * left->camera_T_head.isometry() * lm.inverse(),
                          b = right->camera_T_head.isometry();
  const Eigen::Vector3d behind_mm = b.inverse() * right->face_centre.mm + Eigen::Vector3d(0, 0, 80);
  EXPECT_LT((a * behind_mm - b * behind_mm).norm(), 1.5);
  EXPECT_LT(rotationAngle(a.linear().transpose() * b.linear()) / kRadPerDeg, 0.7);
  EXPECT_GT((b * behind_mm - behind_mm).norm(), 2.0) << "the head has moved";
}

TEST_F(RealFace, OnSidesOfTwoMomentsIsNeverShown) {
  const auto answer = seen("lm", "418", "835", "1252");
  EXPECT_FALSE(answer.isTracked());
  EXPECT_EQ(wordOf(answer), "cameras_disagree");
}

}  // namespace
}  // namespace facenav
