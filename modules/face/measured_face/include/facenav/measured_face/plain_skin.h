#pragma once
// Measures plain skin near a found face, in pictures reduced to the resolution of its coarse texture.

#include "facenav/core/task_monitor.h"
#include "facenav/measured_face/face_in_space.h"

namespace facenav::measured_face {

/// Factor by which pictures are reduced for plain skin: 1, 2, 4 or 8.
int plainReduction(const cameras::StereoRig& rig, const FaceInSpace& face);

/// Converts pixels of reduced pictures to pixels of the whole ones.
void toWholePicture(stereo::FaceCloud& cloud, int times);

/// The face's points with dots or on plain skin, near its centre if that is known. Throws Error as
/// stereo::measureFace.
stereo::FaceCloud measureNear(const cameras::StereoRig& rig, const cameras::StereoFrame& frame, bool has_dots,
                              const FaceInSpace& face, TaskMonitor& monitor);

/// Measures plain skin in whole pictures; pixels are those of the whole pictures.
stereo::FaceCloud measurePlainSkin(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                                   const FaceInSpace& face, TaskMonitor& monitor);

}  // namespace facenav::measured_face
