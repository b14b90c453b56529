#pragma once
// Compares a measured face with the calibration of the cameras that measured it. Camera, mm.

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/measured_face/face_in_space.h"
#include "facenav/stereo/face_cloud.h"

namespace facenav::measured_face {

/// Matches points of the face again in the pictures it was `measured` on. Throws health::RigError if they
/// show that the cameras moved, that the pictures are of two moments, or that the face's depth is likely
/// wrong by either cause. `plain`: the same face without dots. `landmarks`: of the plain picture; where it
/// shows a face, only that part of it counts, because walls and clothes match in wrong places.
void requireUnmovedCameras(const cameras::StereoRig& rig, const cameras::StereoFrame& measured,
                           const cameras::StereoFrame& plain, const stereo::FaceCloud& face,
                           const FaceInSpace& landmarks);

}  // namespace facenav::measured_face
