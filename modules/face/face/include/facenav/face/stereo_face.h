#pragma once
// StereoFace: the face in both images and its triangulated landmarks. It starts and restarts head tracking.

#include <optional>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/face/face_landmarks.h"
#include "facenav/geometry/rigid_transform.h"

namespace facenav::face {

struct StereoFace {
  FaceLandmarks left, right;
  std::vector<Eigen::Vector3d>
      points_mm;  // the 68 landmarks in Camera; empty if no landmark model is installed
};

/// Finds the face in both images and triangulates its landmarks. Returns nothing if one image shows no face,
/// or if the two disagree (epipolar error, depth). `near` restricts the search to the last position.
std::optional<StereoFace> findStereoFace(const FaceDetector& detector, const cameras::StereoRig& rig,
                                         const cameras::StereoFrame& frame, const StereoFace* near = nullptr);

/// Searches the whole images, for faces with roll `roll_rad` only.
std::optional<StereoFace> findStereoFaceAtRoll(const FaceDetector& detector, const cameras::StereoRig& rig,
                                               const cameras::StereoFrame& frame, double roll_rad);

/// The motion that maps the reference landmarks to the current ones. Robust: uses brow, eyes and nose only,
/// and gives outliers a low weight. Returns nothing if they do not fit one rigid face.
std::optional<Eigen::Isometry3d> motionOfLandmarks(const std::vector<Eigen::Vector3d>& reference_mm,
                                                   const std::vector<Eigen::Vector3d>& current_mm);

/// Depth of the face along the left camera's axis, mm: median of the landmarks, or from the two boxes.
double depthOf(const cameras::StereoRig& rig, const StereoFace& face);

}  // namespace facenav::face
