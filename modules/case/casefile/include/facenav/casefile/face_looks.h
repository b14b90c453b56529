#pragma once
// face_looks/ in a case: key frames of the patient's face from earlier sessions (turned, other light,
// smiling), so that the next session finds the face at once. They are photographs: the folder is 0700 and its
// files 0600 from the first byte, and everything but the face is black. Each pose refers to this MRI, so a
// case that is prepared again starts without them.

#include <filesystem>
#include <string>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/geometry/rigid_transform.h"
#include "facenav/geometry/rotation.h"

namespace facenav::casefile {

struct StoredKeyFrame {
  cameras::StereoRig rig;
  cameras::StereoFrame frame;  // the images only, as recorded
  RigidTransform<Camera, Mri> camera_T_mri;
  Matrix6d covariance = Matrix6d::Zero();  // of (w rad, v mm) about the face's centre, in Camera's axes
  std::string captured_utc;                // 20100412T134501Z
};

constexpr std::size_t kMostLooks = 6;

/// Reads the key frames; empty if there are none. Throws Error naming a file that cannot be read or does not
/// fit its rig.
std::vector<StoredKeyFrame> readKeyFrames(const std::filesystem::path& case_folder);
/// Adds key frames to those that exist, all or none. Beyond kMostLooks, the oldest are removed. Sets
/// captured_utc where it is empty. Throws Error.
void addKeyFrames(const std::filesystem::path& case_folder, std::vector<StoredKeyFrame> key_frames);

}  // namespace facenav::casefile
