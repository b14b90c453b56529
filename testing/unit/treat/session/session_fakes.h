#pragma once
// Fake cameras and trackers: known frames, known poses, losses on request.

#include <atomic>
#include <filesystem>
#include <functional>
#include <thread>

#include "facenav/capture/frame_source.h"
#include "facenav/session/navigator.h"

namespace facenav::session::fakes {

inline cameras::StereoRig rig() {
  cameras::StereoRig r;
  r.width_px = 64, r.height_px = 48;
  r.left.k = r.right.k = cv::Matx33d(80, 0, 32, 0, 80, 24, 0, 0, 1);
  r.right_T_left = RigidTransform<RightCamera, Camera>(Eigen::Quaterniond::Identity(), {-120, 0, 0});
  return r;
}

inline std::shared_ptr<const cameras::StereoFrame> frame(std::int64_t number, double captured_s) {
  auto f = std::make_shared<cameras::StereoFrame>();
  f->left = cv::Mat(48, 64, CV_8UC1, cv::Scalar(100));
  f->right = f->left.clone();
  f->number = number;
  f->captured = {captured_s};
  return f;
}

class Source : public capture::FrameSource {
 public:
  Source(int frames, double interval_s, int fails_at = -1)
      : frames_(frames), interval_s_(interval_s), fails_at_(fails_at) {}
  const cameras::StereoRig& rig() const override { return rig_; }
  std::shared_ptr<const cameras::StereoFrame> next() override {
    if (number_ == fails_at_) throw Error("the frame cannot be read", "left/000005.png");
    if (number_ >= frames_) return nullptr;
    const int n = number_++;
    return frame(n, n * interval_s_);
  }

 private:
  cameras::StereoRig rig_ = fakes::rig();
  int frames_, number_ = 0;
  double interval_s_;
  int fails_at_;
};

/// Returns the head's pose as a function of the frame; an empty result is a loss.
class Head : public head_tracking::HeadTracker {
 public:
  using Pose = std::function<std::optional<RigidTransform<Camera, facenav::Head>>(std::int64_t)>;
  explicit Head(Pose pose, int work_ms = 0) : pose_(std::move(pose)), work_ms_(work_ms) {}
  void start(const cameras::StereoRig&, const head_tracking::HeadReference&, head_tracking::Pace) override {}
  head_tracking::HeadResult track(const cameras::StereoFrame& f, const head_tracking::HeadContext&) override {
    std::this_thread::sleep_for(std::chrono::milliseconds(work_ms_));
    const auto pose = pose_(f.number);
    if (!pose) return Lost{LostReason::no_face};
    head_tracking::HeadPose head;
    head.camera_T_head = *pose;
    return Tracked<head_tracking::HeadPose>(head, 0.8);
  }

 private:
  Pose pose_;
  int work_ms_;
};

class Coil : public coil_tracking::CoilTracker {
 public:
  explicit Coil(std::optional<RigidTransform<Camera, Marker>> pose) : pose_(std::move(pose)) {}
  void start(const cameras::StereoRig&, const coil_tracking::CoilModel&) override {}
  coil_tracking::CoilResult track(const cameras::StereoFrame&, const coil_tracking::CoilContext&) override {
    if (!pose_) return Lost{LostReason::no_marker};
    coil_tracking::CoilPose coil;
    coil.camera_T_marker = *pose_;
    for (auto* corners : {&coil.left_corners_px, &coil.right_corners_px})
      *corners = {Eigen::Vector2d(20, 10), Eigen::Vector2d(40, 10), Eigen::Vector2d(40, 30),
                  Eigen::Vector2d(20, 30)};
    return Tracked<coil_tracking::CoilPose>(coil, 0.9);
  }

 private:
  std::optional<RigidTransform<Camera, Marker>> pose_;
};

inline RigidTransform<Camera, Mri> cameraAtReference() {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(2.0, Eigen::Vector3d(1, 2, 3).normalized())), {10, -20, 600}};
}

inline NavigatorSetup setup() {
  NavigatorSetup s;
  s.rig = rig();
  s.camera_T_mri_at_reference = cameraAtReference();
  s.coil.markers.resize(1);
  return s;
}

/// Removes a folder in which another thread may be writing.
inline void removeAll(const std::filesystem::path& folder) {
  for (std::error_code fault; std::filesystem::exists(folder);) std::filesystem::remove_all(folder, fault);
}

/// A target for which the wanted pose of the coil is `camera_T_coil` when the head is at the reference.
inline ChosenTarget targetAt(const RigidTransform<Camera, facenav::Coil>& camera_T_coil) {
  ChosenTarget chosen;
  chosen.target.name = "spot";
  const auto mri_T_coil = cameraAtReference().inverse() * camera_T_coil;
  chosen.target.mri_T_target = mri_T_coil.reframe<Mri, Target>();  // the wanted pose of Coil
  chosen.target.scalp_point = mri_T_coil * Point<facenav::Coil>(0, 0, 0);
  chosen.target.cortex_point = mri_T_coil * Point<facenav::Coil>(0, 0, 15);
  return chosen;
}

}  // namespace facenav::session::fakes
