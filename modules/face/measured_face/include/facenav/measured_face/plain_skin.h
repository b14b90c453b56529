#pragma once
// How plain skin is measured: in pictures reduced to what its coarse texture needs, near the face found.

#include "facenav/core/task_monitor.h"
#include "facenav/measured_face/face_in_space.h"

namespace facenav::measured_face {

/// By how much pictures are reduced for plain skin: 1, 2, 4 or 8.
int plainReduction(const cameras::StereoRig& rig, const FaceInSpace& face);

/// Pixels of reduced pictures as pixels of the whole ones.
void toWholePicture(stereo::FaceCloud& cloud, int times);

/// The face's points with dots, or as plain skin, near its centre if that is known. Throws Error as
/// stereo::measureFace does.
stereo::FaceCloud measureNear(const cameras::StereoRig& rig, const cameras::StereoFrame& frame, bool has_dots,
                              const FaceInSpace& face, TaskMonitor& monitor);

/// Plain skin of whole pictures; pixels are those of the whole pictures.
stereo::FaceCloud measurePlainSkin(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                                   const FaceInSpace& face, TaskMonitor& monitor);

}  // namespace facenav::measured_face
