#pragma once
// FaceShape: the shape of the reference's upper face, fitted to a face that was measured densely without
// dots. The fit is robust point-to-plane least squares over six degrees of freedom; each node has a weight by
// how little its skin moves over the bone. It uses no image texture, so it finds a face in other light or
// with painted cheeks. Its error is about a millimetre; recovery_pose.h then fits the images.

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "facenav/geometry/rotation.h"
#include "facenav/stereo/face_cloud.h"
#include "head/face_region.h"
#include "head/face_surface.h"
#include "skin_mobility.h"

namespace facenav::head_tracking {

class FaceShape {
 public:
  FaceShape() = default;
  FaceShape(const cameras::StereoRig& rig, const FaceRegion& region, const FaceSurface& surface,
            const SkinMobility& mobility);

  /// camera_T_head, fitted near `start` (some 15 degrees, 40 mm); nothing if too little was measured.
  std::optional<Eigen::Isometry3d> fit(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                                       const Eigen::Isometry3d& start) const;

 private:
  struct Node {
    Eigen::Vector3d mm, normal;  // Head
    double mobility_mm;
  };
  std::vector<Node> nodes_;
  Eigen::Vector3d centre_mm_ = Eigen::Vector3d::Zero();
};

}  // namespace facenav::head_tracking
