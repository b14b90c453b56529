#pragma once
// GroundTruth: the truth of one frame of the virtual room: exact poses, visible share of the face, and
// whether a tracker can be expected to give a pose.

#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "facenav/geometry/rigid_transform.h"
#include "facenav/geometry/rotation.h"

namespace facenav::room {

struct GroundTruth {
  std::int64_t frame = 0;
  RigidTransform<Camera, Mri> camera_T_mri;
  std::optional<RigidTransform<Camera, Marker>> camera_T_marker;  // empty if the coil is not in the room
  std::optional<RigidTransform<Camera, Coil>> camera_T_coil;
  std::optional<RigidTransform<Camera, Marker>> camera_T_second_marker;  // of a second coil; empty: none
  std::string label;                                                     // the event, in words
  double face_visible_fraction = 1.0;  // share of the face's skin that both cameras see, 0..1 (0 with a
                                       // camera fault or without the patient)
  bool is_patient_there = true;  // false: another person or no one is there; camera_T_mri is then meaningless
  bool must_be_lost = false;     // the images of this frame do not allow a head pose
  bool is_out_of_step = false;   // the right picture is older than the left; the poses are the left's
  double jaw_mm = 0.0;           // how far the chin is lowered (talking)
  /// Rotation (rad) and shift (mm) of the right camera on its mount since the calibration, in its own frame.
  Vector6d right_moved = Vector6d::Zero();
};

/// Exact depth of the scene in one camera: mm along its z at each pixel's centre; 0 where only the wall is
/// visible.
struct DepthMaps {
  cv::Mat left_mm, right_mm;  // float, H x W
  cv::Mat left_object,
      right_object;  // 8-bit: 0 wall, 1 head, 2 coil, 3 marker plate, 4 hand, above: mask, other objects
};

}  // namespace facenav::room
