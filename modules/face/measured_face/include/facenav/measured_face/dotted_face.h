#pragma once
// Measures a face with projected dots, for an alignment or for a model of the face.

#include "facenav/core/task_monitor.h"
#include "facenav/measured_face/face_in_space.h"

namespace facenav::measured_face {

/// The face's points near the landmarks, or the nearest large surface without landmarks. Throws Error as
/// stereo::measureFace.
stereo::FaceCloud measureDotted(const cameras::StereoRig& rig, const cameras::StereoFrame& dotted,
                                const FaceInSpace& face, const std::string& matcher, TaskMonitor& monitor);

}  // namespace facenav::measured_face
