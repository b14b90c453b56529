#pragma once
// FaceInSpace: the face as found in both images of a plain pair, and its position in space (Camera, mm). It
// gives a start to the alignment (patient's right and up, nose tip) and the region to measure.

#include <optional>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/face/face_landmarks.h"
#include "facenav/registration/aligner.h"
#include "facenav/stereo/face_cloud.h"

namespace facenav::measured_face {

struct FaceInSpace {
  std::optional<face::FaceLandmarks> left, right;
  registration::AlignmentStart start;   // landmarks that were triangulated to a plausible position
  std::optional<Point<Camera>> centre;  // centre of the landmarks
};
FaceInSpace findFace(const cameras::StereoRig& rig, const cameras::StereoFrame& plain,
                     const face::FaceDetector& detector);

/// The part of a cloud that is the face: near the landmarks, or the nearest large surface without landmarks.
stereo::FaceCloud cutFace(const stereo::FaceCloud& cloud, const FaceInSpace& face);

}  // namespace facenav::measured_face
