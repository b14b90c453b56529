#pragma once
// RigObservation: what one frame shows about the cameras. Matches of skin, corners of a board or of the
// coil's marker, the printed size of a square, and the right camera's pose by the tracked face all have this
// one type, each with its error and the frame's time. RigHealth (rig_health.h) estimates from it.

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "facenav/core/timestamp.h"
#include "facenav/geometry/point.h"
#include "facenav/geometry/rotation.h"

namespace facenav::health {

/// One point in both images; each position is measured without the epipolar line.
struct Correspondence {
  Eigen::Vector2d left_px, right_px;
  double sigma_px = 0.2;  // error across the epipolar line
};

/// Patches of 15 px side by side on a glint, a fold, a strand of hair or a compression block share their
/// errors: this fraction of their scatter does not average out in a part of the image.
constexpr double kSharedShare = 0.3;

/// A square of known size (a marker, squares of a board) with its corners in order, in both images. Across
/// the epipolar lines each image is measured independently.
struct SquareObservation {
  std::array<Eigen::Vector2d, 4> left_px, right_px;
  double sigma_px = 0.0;        // error of a corner across the epipolar lines
  double size_mm = 0.0;         // edge of the square, as printed
  double print_sigma_mm = 0.0;  // standard error of size_mm
  double size_sigma_mm = 0.0;   // standard error of the size measured in both images
};

/// Motion of the right camera on its mount since a key frame, from the face: each camera by itself measures
/// the pose of the known face. Relative to the rig that the frame was tracked with.
struct RightPoseObservation {
  Vector6d moved = Vector6d::Zero();  // (rad, mm), right camera: its pose is exp(moved) * right_T_left
  Matrix6d covariance = Matrix6d::Zero();
  /// Effect of the motion on the head's pose: pose_by_moved * moved, as (w rad, v mm) about the face's
  /// centre.
  Matrix6d pose_by_moved = Matrix6d::Zero();
  int key = 0,
      newest_key = 0;  // key frame of this fit and newest key frame; 0: reference
};

struct RigObservation {
  Timestamp captured;
  std::vector<Correspondence> matches;      // skin patches
  std::optional<SquareObservation> square;  // the coil's marker at rest
  std::optional<bool> square_fits;  // its pose fits both cameras and its printed size; nullopt: not seen
  bool sees_face = false;
  Point<Camera> face_centre;                         // place of the tracked face
  std::optional<RightPoseObservation> right_camera;  // nullopt if the face shows too little of it
};

}  // namespace facenav::health
