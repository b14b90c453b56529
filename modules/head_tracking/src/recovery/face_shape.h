#pragma once
// FaceShape: the shape of the reference's upper face, and where a face measured densely without dots lies
// against it: robust point-to-plane least squares over six degrees of freedom, each place weighted by how
// little its skin moves over the bone. It needs no looks: a face in other light, or whose cheeks are painted,
// is found by it. It shows the head to about a millimetre; recovery_pose.h then fits the pictures.

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

struct ShapeFit {
  Eigen::Isometry3d camera_T_head = Eigen::Isometry3d::Identity();
  double rms_mm = 0.0;  // robust, of the measured skin about the reference's, bridge, forehead and temples
  int nodes = 0;        // of the reference's upper face, that were measured
};

class FaceShape {
 public:
  FaceShape() = default;
  FaceShape(const cameras::StereoRig& rig, const FaceRegion& region, const FaceSurface& surface,
            const SkinMobility& mobility);

  /// Of the pair, near `start` (some 15 degrees, 40 mm). Nothing where too little could be measured.
  std::optional<ShapeFit> fit(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
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
