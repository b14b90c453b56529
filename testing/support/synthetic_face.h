#pragma once
// SyntheticFace: a portrait on a head-like height field (ellipsoid, nose, eye sockets), seen by a stereo rig
// and rendered by inverse ray casting with known motion. It replaces the virtual room in tests that need one
// module only.

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/head_tracking/head_tracker.h"

namespace facenav::testing {

struct SyntheticView {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();  // of the head since the reference, in Camera
  double noise_grey = 1.5;
  std::uint64_t seed = 1;
  double gain = 1.0, lamp_x = 0.2;  // brightness; x component of the lamp's direction
  cv::Rect2d cover_mm;              // part of the face (head x, y in mm) hidden by a grey plate; empty: none
  double jaw_drop_mm = 0.0;         // largest downward shift of the skin below the mouth
  double time_s = 0.0;
};

class SyntheticFace {
 public:
  /// The public-domain portrait of python3-skimage, or another 8-bit image in which `eyes_px` are the outer
  /// eye corners (image left, image right).
  explicit SyntheticFace(const cv::Mat& portrait, Eigen::Vector2d left_eye_px, Eigen::Vector2d right_eye_px);
  static std::string portraitPath() { return "/usr/lib/python3/dist-packages/skimage/data/astronaut.png"; }
  static SyntheticFace astronaut();
  /// Makes another person: the portrait with moved and mirrored features.
  static SyntheticFace stranger();

  cameras::StereoFrame render(const cameras::StereoRig& rig, const SyntheticView& view) const;
  /// Reference with the exact surface, as from dense dots, or without a surface.
  head_tracking::HeadReference reference(const cameras::StereoRig& rig, bool with_surface,
                                         const SyntheticView& view = {}) const;

 private:
  cv::Mat image(const cameras::CameraModel& camera, const Eigen::Isometry3d& camera_T_left, cv::Size size,
                const SyntheticView& view, std::uint64_t seed) const;
  double height(double x, double y) const;
  /// `near_t`: in: position of the hit on a neighbouring ray, or 0; out: position of this hit.
  Eigen::Vector3d hit(const Eigen::Vector3d& origin, const Eigen::Vector3d& ray, bool& is_hit,
                      double& near_t) const;

  cv::Mat1f portrait_;
  Eigen::Vector2d texture_centre_px_;
  double texture_px_per_mm_;
  double nose_mm_ = 20.0;
};

/// Converging pair: f 800 px, 640 x 480, baseline 120 mm, 10 degrees, mild distortion; the face at 600 mm.
cameras::StereoRig faceRig();

}  // namespace facenav::testing
