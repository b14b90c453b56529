#pragma once
// StereoFace: the face in both images and its landmarks in space: what starts and restarts a head track.

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
      points_mm;  // the 68 landmarks in Camera; empty where no landmark model is installed
};

/// The face in both images, its landmarks triangulated; nothing when one image holds none or the two disagree
/// (epipolar distance, depth). `near` narrows the search to where it was.
std::optional<StereoFace> findStereoFace(const FaceDetector& detector, const cameras::StereoRig& rig,
                                         const cameras::StereoFrame& frame, const StereoFace* near = nullptr);

/// The same over the whole images, faces rolled by `roll_rad` only.
std::optional<StereoFace> findStereoFaceAtRoll(const FaceDetector& detector, const cameras::StereoRig& rig,
                                               const cameras::StereoFrame& frame, double roll_rad);

/// The motion that brings the reference landmarks onto the current ones (robust: brow, eyes and nose only,
/// the worst left out); nothing when they do not fit as one rigid face.
std::optional<Eigen::Isometry3d> motionOfLandmarks(const std::vector<Eigen::Vector3d>& reference_mm,
                                                   const std::vector<Eigen::Vector3d>& current_mm);

/// The face's distance along the left camera's axis, mm: the middle landmark's, or that of the two boxes.
double depthOf(const cameras::StereoRig& rig, const StereoFace& face);

}  // namespace facenav::face
