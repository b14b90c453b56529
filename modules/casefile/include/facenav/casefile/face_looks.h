#pragma once
// face_looks/ in a case: how the patient's face looked in earlier sessions (turned, lit, smiling), so that it
// is found at once in the next. Photographs: the folder is 0700 and its files 0600 from the first byte; all
// but the face is black. Pose and MRI belong together: a case that is prepared anew starts without them.

#include <filesystem>
#include <string>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/geometry/rigid_transform.h"
#include "facenav/geometry/rotation.h"

namespace facenav::casefile {

struct KeptLook {
  cameras::StereoRig rig;
  cameras::StereoFrame frame;  // the pictures only, as recorded
  RigidTransform<Camera, Mri> camera_T_mri;
  Matrix6d covariance = Matrix6d::Zero();  // of (w rad, v mm) about the face's centre, Camera's axes
  std::string captured_utc;                // 20100412T134501Z
};

constexpr std::size_t kMostLooks = 6;

/// Empty where there are none. Throws Error naming a file that cannot be read, or does not fit its rig.
std::vector<KeptLook> readFaceLooks(const std::filesystem::path& case_folder);
/// Adds looks to those that are there, whole or not at all; of more than kMostLooks the oldest go. Sets
/// captured_utc where it is empty. Throws Error.
void addFaceLooks(const std::filesystem::path& case_folder, std::vector<KeptLook> looks);

}  // namespace facenav::casefile
