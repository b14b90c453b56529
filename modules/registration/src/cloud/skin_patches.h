#pragma once
// Patches: the residuals of neighbouring points are alike (the skin model is off by the same amount there, a
// hair lifts them all), so that patches of a centimetre, not points, are what counts as a measurement.

#include <vector>

#include "fit/field_fit.h"

namespace facenav::registration {

struct SkinPatch {
  Eigen::Vector3d at_mri_mm = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero();
  Vector6d jacobian = Vector6d::Zero();  // of the residual by (turn, shift) of mri_T_camera about the pivot
  double residual_mm = 0.0;              // positive: the live skin lies outside the MRI's
  double noise_mm = 0.0;                 // one sigma of what varies within the patch
  int points = 0;
  double covered = 1.0;  // share of its points that lie within the limit of the skin
};

struct PatchLimits {
  double size_mm = 12.0;
  double inside_mm = 1.5, outside_mm = 1.5;  // residuals beyond do not belong to the skin
};

/// Patches with at least 5 points within the limits, seen from `mri_T_camera`'s camera; jacobians about
/// `pivot_mri_mm`.
std::vector<SkinPatch> gatherPatches(const std::vector<PointMatch>& matches, const PatchLimits& limits,
                                     const Eigen::Isometry3d& mri_T_camera,
                                     const Eigen::Vector3d& pivot_mri_mm);

}  // namespace facenav::registration
