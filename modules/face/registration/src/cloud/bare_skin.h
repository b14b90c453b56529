#pragma once
// Covers: finds the points of the cloud on bare skin once the pose is roughly known. Hair, a mask, a hand and
// other occlusions are left out of the fit as whole patches.

#include <Eigen/Geometry>
#include <vector>

#include "cube_numbers.h"
#include "facenav/geometry/point.h"
#include "facenav/registration/scalp_field.h"

namespace facenav::registration {

/// The covered patches of the cloud.
class Covers {
 public:
  Covers() = default;
  /// Decides at a pose within 1 to 2 mm of the true one. `points`: 3 to 5 mm apart. `noise_mm`: as in
  /// AlignmentStart.
  Covers(const ScalpField& scalp, const PointCloud<Camera>& face, const std::vector<int>& points,
         const Eigen::Isometry3d& mri_T_camera, double noise_mm);

  bool hold(const Eigen::Vector3d& p_camera_mm) const;
  /// The `points` that are not covered.
  std::vector<int> bare(const PointCloud<Camera>& face, const std::vector<int>& points) const;

 private:
  static constexpr double kPatch_mm = 12.0;
  CubeNumbers cubes_{kPatch_mm};
};

}  // namespace facenav::registration
