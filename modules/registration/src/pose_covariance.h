#pragma once
// How far the fitted pose may be off. Residuals of neighbouring points are alike (the skin model is off by
// the same amount there), so the count of independent measurements is that of patches, not of points: a
// sandwich estimate over patches, plus a common offset of skin against cloud, which no residual shows.

#include <vector>

#include "pose_fit.h"

namespace facenav::registration {

struct UncertaintyModel {
  double patch_mm = 30.0;         // residuals farther apart count as independent
  double alike = 2.0;             // variance factor: misfit of neighbouring patches is alike
  double common_offset_mm = 0.2;  // one sigma of a bias of the whole skin along its normals
  double least_patch_mm = 0.1;    // no patch is trusted further
};

/// Covariance of (rotation rad, translation mm): left increment in Camera at the image of Mri's origin.
/// `weights`: what each match weighed in the fit (0: not used).
Matrix6d poseCovariance(const std::vector<PointMatch>& matches, const std::vector<double>& weights,
                        const Eigen::Isometry3d& mri_T_camera, const UncertaintyModel& model);

/// Key of the cube of `size_mm` that a point lies in.
long long patchKey(const Eigen::Vector3d& p_mm, double size_mm);

}  // namespace facenav::registration
