#pragma once
// SkinUnder: how deep the skin lies under each place of a target's plane, so that figures can be laid on the
// head. Private to pictures.

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <optional>

#include "facenav/surface/triangle_mesh.h"

namespace facenav::pictures {

class SkinUnder {
 public:
  /// `plane_T_mri`: the skin in the plane's frame, its +z into the head. Only skin that faces the plane
  /// counts.
  SkinUnder(const surface::TriangleMesh& skin, const Eigen::Isometry3d& plane_T_mri);
  /// Depth of the skin at (x, y) of the plane, mm along z; nothing where there is none.
  std::optional<double> depth_mm(double x_mm, double y_mm) const;

  static constexpr double kReach_mm = 130, kCell_mm = 1.0;

 private:
  cv::Mat depth_mm_;  // 32-bit float, NaN: no skin
};

}  // namespace facenav::pictures
