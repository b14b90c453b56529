#pragma once
// Patches: the residuals of neighbouring points are alike (the skin model is off by the same amount there, a
// hair lifts them all), so that patches of a centimetre, not points, are what counts as a measurement.

#include <vector>

#include "field_fit.h"

namespace facenav::registration {

struct SkinPatch {
  Eigen::Vector3d at_mri_mm = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero();
  Vector6d jacobian = Vector6d::Zero();  // of the residual by (turn, shift) of mri_T_camera about the pivot
  double residual_mm = 0.0;              // positive: the live skin lies outside the MRI's
  double noise_mm = 0.0;                 // one sigma of what varies within the patch
  int points = 0;
  double covered = 1.0;  // share of its points that lie within the limit of the skin
};

/// Patches of `size_mm` with at least 5 points within `limit_mm`. `index` (may be null): of each match's
/// patch, or -1.
std::vector<SkinPatch> gatherPatches(const std::vector<PointMatch>& matches, double size_mm, double limit_mm,
                                     const Eigen::Vector3d& pivot_mri_mm, std::vector<int>* index = nullptr);

}  // namespace facenav::registration
