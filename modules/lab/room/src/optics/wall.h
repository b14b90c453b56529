#pragma once
// Wall behind the patient: soft structure, wallpaper of stripes, checks or spots, and bright windows.

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <vector>

#include "camera_rays.h"
#include "facenav/room/room_wall.h"

namespace facenav::room {

/// Radiance of the wall as seen by a camera (float, H x W, at full light).
cv::Mat renderWall(const CameraRays& rays, const Eigen::Isometry3d& room_T_world, const RoomWall& wall);

}  // namespace facenav::room
