#pragma once
// Common parts of the tests of both head trackers: a synthetic face with known motion.

#include <gtest/gtest.h>

#include <map>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "facenav/core/error.h"
#include "facenav/geometry/pose_error.h"
#include "facenav/geometry/rotation.h"
#include "facenav/head_tracking/head_tracker.h"
#include "facenav/peers/feature_head_tracker.h"
#include "support/matchers.h"
#include "support/synthetic_face.h"
#include "support/test_data.h"

namespace facenav::head_tracking::testing {

using facenav::testing::SyntheticFace;
using facenav::testing::SyntheticView;

inline const Point<Head> kCortex(0, -60, 690);  // some 90 mm behind the face

/// The detector that the trackers use. It remembers its result for an image, because every test starts from
/// the same reference.
class RememberingDetector : public face::FaceDetector {
 public:
  std::optional<face::FaceLandmarks> detect(const cv::Mat& grey) const override {
    for (const auto& [picture, answer] : answers_)
      if (picture.size() == grey.size() && cv::norm(picture, grey, cv::NORM_INF) == 0) return answer;
    answers_.emplace_back(grey.clone(), detector_->detect(grey));
    return answers_.back().second;
  }
  std::optional<face::FaceLandmarks> detectNear(const cv::Mat& grey,
                                                const face::FaceLandmarks& last) const override {
    return detector_->detectNear(grey, last);
  }
  std::optional<face::FaceLandmarks> detectAtRoll(const cv::Mat& grey, double roll_rad) const override {
    return detector_->detectAtRoll(grey, roll_rad);
  }

 private:
  std::unique_ptr<face::FaceDetector> detector_ = face::makeFaceDetector();
  mutable std::vector<std::pair<cv::Mat, std::optional<face::FaceLandmarks>>> answers_;
};

inline std::shared_ptr<const face::FaceDetector> detector() {
  static const auto shared = std::make_shared<const RememberingDetector>();
  return shared;
}

inline std::unique_ptr<head_tracking::HeadTracker> make(bool is_model) {
  return is_model ? head_tracking::makeModelHeadTracker(detector())
                  : peers::makeFeatureHeadTracker(detector());
}

inline Eigen::Isometry3d motionAt(double phase, double yaw_deg) {
  Vector6d xi;
  xi << 0.4 * yaw_deg * kRadPerDeg * std::sin(phase), yaw_deg * kRadPerDeg * std::sin(phase + 0.3),
      0.3 * yaw_deg * kRadPerDeg * std::cos(phase), 20 * std::sin(phase), 10 * std::cos(phase) - 10,
      15 * std::sin(2 * phase);
  return Eigen::Translation3d(0, 0, 640) * expRigid(xi) * Eigen::Translation3d(0, 0, -640);
}

inline SyntheticView viewAt(int frame, double yaw_deg) {
  SyntheticView view;
  view.motion = motionAt(2 * M_PI * frame / 60.0, yaw_deg);
  view.seed = std::uint64_t(frame) + 1;
  view.time_s = frame / 30.0;
  return view;
}

/// The view with the head rotated by `yaw_deg` about the neck.
inline SyntheticView turnedView(int frame, double yaw_deg) {
  SyntheticView view;
  view.motion = Eigen::Translation3d(0, 0, 700) *
                Eigen::AngleAxisd(yaw_deg * kRadPerDeg, Eigen::Vector3d::UnitY()) *
                Eigen::Translation3d(0, 0, -700);
  view.seed = std::uint64_t(frame) + 1;
  view.time_s = frame / 30.0;
  return view;
}

inline SyntheticView stillView(int frame) {
  SyntheticView view;
  view.seed = std::uint64_t(frame) + 1;
  view.time_s = frame / 30.0;
  return view;
}

struct Errors {
  int frames = 0, lost = 0;
  double target_rms_mm = 0, rotation_rms_deg = 0, worst_mm = 0;
};

inline PoseError errorOf(const head_tracking::HeadPose& pose, const SyntheticView& view) {
  return poseError(pose.camera_T_head, RigidTransform<Camera, Head>::fromIsometry(view.motion), kCortex);
}

/// Words for the reason of a loss; empty while the head is tracked.
inline std::string wordOf(const head_tracking::HeadResult& result) {
  if (result) return {};
  const std::string word = head_tracking::toString(result.loss_detail);
  return word.empty() ? "lost" : word;
}

class HeadTrackers : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(SyntheticFace::portraitPath()))
      GTEST_SKIP() << "no portrait (python3-skimage)";
    rig_ = facenav::testing::faceRig();
    static const SyntheticFace shared = SyntheticFace::astronaut();  // its rays are computed once
    face_ = &shared;
  }
  void start(head_tracking::HeadTracker& tracker, bool with_surface) const {
    static std::map<bool, head_tracking::HeadReference> references;
    if (references.count(with_surface) == 0) {
      SyntheticView view;
      view.seed = 99;
      references[with_surface] = face_->reference(rig_, with_surface, view);
    }
    tracker.start(rig_, references[with_surface]);
  }
  Errors follow(head_tracking::HeadTracker& tracker, const std::vector<SyntheticView>& views) const {
    Errors errors;
    for (const auto& view : views) {
      ++errors.frames;
      const auto pose = tracker.track(face_->render(rig_, view));
      if (!pose) {
        ++errors.lost;
        continue;
      }
      const auto error = errorOf(*pose, view);
      errors.target_rms_mm += error.at_point_mm * error.at_point_mm;
      errors.rotation_rms_deg += std::pow(error.rotation_rad / kRadPerDeg, 2);
      errors.worst_mm = std::max(errors.worst_mm, error.at_point_mm);
    }
    const double n = std::max(1, errors.frames - errors.lost);
    errors.target_rms_mm = std::sqrt(errors.target_rms_mm / n);
    errors.rotation_rms_deg = std::sqrt(errors.rotation_rms_deg / n);
    return errors;
  }
  static std::vector<SyntheticView> sweep(double yaw_deg, int step, int frames = 60) {
    std::vector<SyntheticView> views;
    for (int frame = 0; frame < frames; frame += step) views.push_back(viewAt(frame, yaw_deg));
    return views;
  }

  cameras::StereoRig rig_;
  const SyntheticFace* face_ = nullptr;
};

}  // namespace facenav::head_tracking::testing
