#pragma once
// How a face with projected dots is measured, for an alignment and for a model of the face.

#include "facenav/core/task_monitor.h"
#include "facenav/measured_face/face_in_space.h"

namespace facenav::measured_face {

/// The face's points near the landmarks, or the nearest large surface without them. Throws Error as
/// stereo::measureFace does.
stereo::FaceCloud measureDotted(const cameras::StereoRig& rig, const cameras::StereoFrame& dotted,
                                const FaceInSpace& face, const std::string& matcher, TaskMonitor& monitor);

}  // namespace facenav::measured_face
