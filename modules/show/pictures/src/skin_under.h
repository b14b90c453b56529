#pragma once
// SkinUnder: depth of the skin under each point of a target's plane, to draw figures on the head. Private to
// pictures.

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <optional>

#include "facenav/surface/triangle_mesh.h"

namespace facenav::pictures {

class SkinUnder {
 public:
  /// Computes the depths. `plane_T_mri`: Mri in the plane's frame, whose +z points into the head. Only skin
  /// that faces the plane is used.
  SkinUnder(const surface::TriangleMesh& skin, const Eigen::Isometry3d& plane_T_mri);
  /// Depth of the skin at (x, y) of the plane, mm along z; nothing where there is none.
  std::optional<double> depth_mm(double x_mm, double y_mm) const;

  static constexpr double kReach_mm = 130, kCell_mm = 1.0;

 private:
  cv::Mat depth_mm_;  // 32-bit float, NaN: no skin
};

}  // namespace facenav::pictures
