#pragma once
// FaceKeyFrame: the patient's face as one pair of pictures showed it at a known pose: another expression,
// side or light than the reference's. A lost face is searched for in every look that is known.

#include <Eigen/Geometry>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/geometry/rotation.h"

namespace facenav::head_tracking {

struct FaceKeyFrame {
  cameras::StereoRig rig;      // of the cameras that took it
  cameras::StereoFrame frame;  // black outside the face
  Eigen::Isometry3d camera_T_head = Eigen::Isometry3d::Identity();
  Matrix6d covariance = Matrix6d::Zero();  // of that pose, HeadPose's, about the face's centre
  /// The same, of what lies between its session and this one: stated with poses found by it, no reason to
  /// refuse them.
  Matrix6d between_sessions = Matrix6d::Zero();
};

}  // namespace facenav::head_tracking
