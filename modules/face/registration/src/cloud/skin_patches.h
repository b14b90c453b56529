#pragma once
// Patches of skin. The residuals of neighbouring points are correlated: the skin model has the same error
// there, a hair lifts them all. Therefore a patch of one centimetre, not a point, is one observation.

#include <vector>

#include "fit/field_fit.h"

namespace facenav::registration {

/// Edge of the patches that the model of misfits counts.
constexpr double kModelPatch_mm = 12.0;

struct SkinPatch {
  Eigen::Vector3d at_mri_mm = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero();
  Vector6d jacobian = Vector6d::Zero();  // of the residual by (turn, shift) of mri_T_camera about the pivot
  double residual_mm = 0.0;              // positive: live skin outside the MRI's
  double noise_mm = 0.0;                 // standard deviation within the patch
  int points = 0;
  double covered = 1.0;  // share of its points within the limits
};

struct PatchLimits {
  double size_mm = kModelPatch_mm;
  double inside_mm = 1.5, outside_mm = 1.5;  // larger residuals are not skin
};

/// Patches with at least 5 points within the limits, seen from `mri_T_camera`'s camera; jacobians about
/// `pivot_mri_mm`.
std::vector<SkinPatch> gatherPatches(const std::vector<PointMatch>& matches, const PatchLimits& limits,
                                     const Eigen::Isometry3d& mri_T_camera,
                                     const Eigen::Vector3d& pivot_mri_mm);

}  // namespace facenav::registration
