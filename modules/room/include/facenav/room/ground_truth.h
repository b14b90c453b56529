#pragma once
// GroundTruth: what is really there in one frame of the virtual room: exact poses, what hides the face, what
// a tracker can be expected to know.

#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "facenav/geometry/rigid_transform.h"

namespace facenav::room {

struct GroundTruth {
  std::int64_t frame = 0;
  RigidTransform<Camera, Mri> camera_T_mri;
  std::optional<RigidTransform<Camera, Marker>> camera_T_marker;  // nothing where the coil is not in the room
  std::optional<RigidTransform<Camera, Coil>> camera_T_coil;
  std::string label;                   // what happens, in words
  double face_visible_fraction = 1.0;  // share of the face's skin that both cameras see, 0..1 (0 with a
                                       // camera fault or without the patient)
  bool is_patient_there =
      true;                   // false: another person sits there, or nobody; camera_T_mri then says nothing
  bool must_be_lost = false;  // no honest tracker can give the head's pose in this frame
  bool is_out_of_step =
      false;            // the right camera's picture is of an earlier moment; the poses are the left's
  double jaw_mm = 0.0;  // how far the chin is lowered (talking)
};

/// Depth of the scene in one camera, exact: mm along its z at each pixel's centre, 0 where only the wall is.
struct DepthMaps {
  cv::Mat left_mm, right_mm;  // float, H x W
  cv::Mat left_object,
      right_object;  // 8-bit: 0 wall, 1 head, 2 coil, 3 marker plate, 4 hand, more: mask, others
};

}  // namespace facenav::room
