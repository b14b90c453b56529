#pragma once
// The sphere that stands for the head under a coil: fitted to the points of a surface near the coil. Only its
// centre counts for the field (primary_field.h).

#include <Eigen/Core>
#include <vector>

namespace facenav::efield {

struct LocalSphere {
  Eigen::Vector3d centre_mm = Eigen::Vector3d::Zero();
  double radius_mm = 0;
  bool is_local = true;  ///< false: the points near the coil were too flat or too few, all points were used
};

/// Fits a sphere to the points within 80 mm of the coil's centre, by linear least squares. Where that sphere
/// has not the size of a head (radius 30 to 130 mm), all points are used. Throws Error for fewer than 4
/// points, or if all of them fit no such sphere.
LocalSphere localSphere(const std::vector<Eigen::Vector3d>& surface_mm, const Eigen::Vector3d& coil_mm);

}  // namespace facenav::efield
