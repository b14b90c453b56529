#include "facenav/session/face_memory.h"

#include <gtest/gtest.h>

#include "session_fakes.h"
#include "support/matchers.h"

namespace facenav::session {
namespace {

using facenav::testing::PoseNear;

RigidTransform<Camera, Head> moved() {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, -2, 1).normalized())), {12, -7, 30}};
}

/// Head tracker with one learnt key frame of the face; records the key frames that it gets.
class LearningHead : public fakes::Head {
 public:
  explicit LearningHead(std::vector<head_tracking::FaceKeyFrame>& given)
      : fakes::Head([](auto) { return moved(); }), given_(given) {}
  void start(const cameras::StereoRig&, const head_tracking::HeadReference& reference,
             head_tracking::Pace) override {
    given_ = reference.key_frames;
  }
  std::vector<head_tracking::FaceKeyFrame> learntKeyFrames() const override {
    head_tracking::FaceKeyFrame look;
    look.rig = fakes::rig();
    look.frame = *fakes::frame(1, 0.1);
    look.camera_T_head = moved().isometry();
    return {look};
  }

 private:
  std::vector<head_tracking::FaceKeyFrame>& given_;
};

std::vector<casefile::StoredKeyFrame> learnt(const NavigatorSetup& setup,
                                             std::vector<head_tracking::FaceKeyFrame>& given) {
  return Navigator(setup, std::make_unique<LearningHead>(given), std::make_unique<fakes::Coil>(std::nullopt))
      .learntKeyFrames();
}

TEST(FaceMemory, ALookKeepsItsPlaceInTheMriFromOneSessionToTheNext) {
  std::vector<head_tracking::FaceKeyFrame> given;
  NavigatorSetup first = fakes::setup();
  const auto kept = learnt(first, given);
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_TRUE(given.empty());
  EXPECT_THAT(kept[0].camera_T_mri,
              PoseNear(moved() * fakes::cameraAtReference().reframe<Head, Mri>(), 1e-9, 1e-9));

  NavigatorSetup second = fakes::setup();  // in this session the patient has another seat at the reference
  const RigidTransform<Camera, Mri> there(
      Eigen::Quaterniond(Eigen::AngleAxisd(-1.0, Eigen::Vector3d(3, 1, 2).normalized())), {-40, 10, 580});
  second.camera_T_mri_at_reference = there;
  second.key_frames = kept;
  learnt(second, given);
  ASSERT_EQ(given.size(), 1u);
  const auto camera_T_mri =
      RigidTransform<Camera, Head>::fromIsometry(given[0].camera_T_head) * there.reframe<Head, Mri>();
  EXPECT_THAT(camera_T_mri, PoseNear(kept[0].camera_T_mri, 1e-9, 1e-9));
  EXPECT_GT(given[0].between_sessions(3, 3), 0.1) << "two alignments lie between";
}

TEST(FaceMemory, WithoutAnAlignmentNothingIsKept) {
  std::vector<head_tracking::FaceKeyFrame> given;
  NavigatorSetup setup = fakes::setup();
  setup.camera_T_mri_at_reference.reset();
  EXPECT_TRUE(learnt(setup, given).empty());
}

}  // namespace
}  // namespace facenav::session
