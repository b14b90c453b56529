#pragma once
// FaceKeyFrame: one stereo pair with the patient's face at a known pose, with another expression, side or
// light than the reference. A lost face is searched for with every known key frame.

#include <Eigen/Geometry>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/geometry/rotation.h"

namespace facenav::head_tracking {

struct FaceKeyFrame {
  cameras::StereoRig rig;      // of the cameras that took the pair
  cameras::StereoFrame frame;  // black outside the face
  Eigen::Isometry3d camera_T_head = Eigen::Isometry3d::Identity();
  Matrix6d covariance = Matrix6d::Zero();  // of that pose, as in HeadPose, about the face's centre
  /// Covariance of changes between the key frame's session and this one. It is added to poses found with this
  /// key frame, but does not make the tracker refuse them.
  Matrix6d between_sessions = Matrix6d::Zero();
};

}  // namespace facenav::head_tracking
