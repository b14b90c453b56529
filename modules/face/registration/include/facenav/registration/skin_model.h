#pragma once
// SkinModel: the skin of the MRI as input of this module (Mri, mm). It uses no types of the surface module.

#include <utility>
#include <vector>

#include "facenav/geometry/point.h"

namespace facenav::registration {

/// Points with outward unit normals, and triangles over them. `has_face` is false for a defaced scan.
struct SkinModel {
  PointCloud<Mri> points;
  std::vector<Eigen::Vector3i> triangles;
  /// Planes of the field of view, Mri, where the scan ends. Points of the cloud beyond them have no
  /// counterpart. Unit normals point out of the scan.
  std::vector<std::pair<Point<Mri>, Direction<Mri>>> field_of_view;
  bool has_face = true;
};

}  // namespace facenav::registration
