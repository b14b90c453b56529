#pragma once
// Pose and covariance when the misfit of live skin and MRI is correlated, not white noise. The residuals are
// a random field over the skin (Gaussian process): the sum of an offset of the whole skin (the scan's edge
// may lie anywhere in the dermis), a scale error of the scan along each axis, and a smooth field that is
// larger over soft tissue. Size and reach of the field are estimated from the residuals by restricted maximum
// likelihood (Patterson and Thompson 1971). The pose is estimated under a simple working covariance, its
// uncertainty under the field (Liang and Zeger 1986). Generalised least squares under the field would depend
// on small differences between smooth deformation and pose, and one face does not determine the field well
// enough for that. The covariance includes deformations that look like a change of pose and therefore leave
// no residual.

#include <array>
#include <functional>
#include <optional>
#include <utility>

#include "cloud/skin_patches.h"
#include "facenav/anatomy/face_regions.h"
#include "facenav/registration/aligner.h"
#include "facenav/registration/misfit_prior.h"

namespace facenav::registration {

struct PosePosterior {
  Vector6d error = Vector6d::Zero();       // error of the pose: (turn rad, shift mm) about the pivot in Mri
  Matrix6d covariance = Matrix6d::Zero();  // covariance of that error
  double freedom = 30.0;                   // degrees of freedom of its t distribution
  double field_mm = 0.0;                   // size of the smooth field over firm skin
  double reach_mm = 0.0;                   // correlation length of the smooth field
  // Size of the live face over that of the scan, minus one, and its standard error: a seventh unknown, fitted
  // together with the pose without a prior on the scan's scale. Causes are cameras calibrated with a square
  // of the wrong size, or a scanner's gradients. The pose is not corrected by it.
  double scale = 0.0, scale_sigma = 0.0;
  // Turn of the right camera (SeenFrom::turn_mm), fitted together with the pose under the prior on the scan's
  // scale.
  std::optional<CameraTurn> turn;
  Vector6d error_by_turn = Vector6d::Zero();  // change of `error` by a turn of the right camera, per rad
};

/// The camera that the cloud is seen from, and the cloud's error along its lines of sight.
struct SeenFrom {
  Eigen::Vector3d camera_mri_mm = Eigen::Vector3d::Zero();
  SightError error;
  /// Displacement (mm per rad, Mri) of a measured point (Mri, mm) by a turn of the right camera; empty: not
  /// estimated.
  std::function<Eigen::Vector3d(const Eigen::Vector3d&)> turn_mm = {};
};

/// Error of a pose (turn rad, shift mm, about the pivot) under the working covariance alone.
Vector6d poseError(const std::vector<SkinPatch>& patches, const anatomy::FaceRegions& regions,
                   const Eigen::Vector3d& pivot_mri_mm);

/// Error and covariance under the whole model with its prior. `patches`: about 12 mm. The weight of patches
/// more than 3 sigma from their neighbours' prediction decreases gradually.
PosePosterior posteriorOf(const std::vector<SkinPatch>& patches, const anatomy::FaceRegions& regions,
                          const Eigen::Vector3d& pivot_mri_mm, const MisfitPrior& prior,
                          const SeenFrom& seen = {});

}  // namespace facenav::registration
