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
      points_mm;  // the 68 landmarks in Camera; empty when no landmark model is installed
};

/// The face in both images with triangulated landmarks. Nothing when one image shows no face, or the two
/// disagree (epipolar error, depth). `near` restricts the search to the last position.
std::optional<StereoFace> findStereoFace(const FaceDetector& detector, const cameras::StereoRig& rig,
                                         const cameras::StereoFrame& frame, const StereoFace* near = nullptr);

/// The same in the whole images, for faces with roll `roll_rad` only.
std::optional<StereoFace> findStereoFaceAtRoll(const FaceDetector& detector, const cameras::StereoRig& rig,
                                               const cameras::StereoFrame& frame, double roll_rad);

/// The motion that maps the reference landmarks to the current ones. Robust: brow, eyes and nose only, with
/// low weight for outliers. Nothing when they do not fit one rigid face.
std::optional<Eigen::Isometry3d> motionOfLandmarks(const std::vector<Eigen::Vector3d>& reference_mm,
                                                   const std::vector<Eigen::Vector3d>& current_mm);

/// Depth of the face along the left camera's axis, mm: median of the landmarks, or from the two boxes.
double depthOf(const cameras::StereoRig& rig, const StereoFace& face);

}  // namespace facenav::face
