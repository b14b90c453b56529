#pragma once
// The pose and how far it may be off, when the misfit of live skin and MRI is no white noise. Residuals are
// modelled as a random field over the skin (Gaussian process) that any same person's scan may show: an
// offset of the whole skin (where in the dermis the scan's edge lies), a scale of the scan along each axis,
// and a smooth field whose size and reach are estimated from the residuals themselves by restricted maximum
// likelihood (Patterson and Thompson 1971), larger over soft tissue. The pose itself is estimated under a
// simple working covariance, its uncertainty under the field (Liang and Zeger 1986): generalised least
// squares under the field would follow what little tells its smooth deformations from a pose, and one face
// says too little about the field for that (0.33 mm instead of 0.24 at the cortex; 0.91 instead of 0.44 where
// the scan's edge is poor). The covariance holds the deformations that no residual shows because a pose
// imitates them.

#include <array>
#include <utility>

#include "cloud/skin_patches.h"
#include "facenav/anatomy/face_regions.h"
#include "facenav/registration/misfit_prior.h"

namespace facenav::registration {

struct PosePosterior {
  Vector6d error = Vector6d::Zero();  // (turn rad, shift mm) about the pivot in Mri: what the pose is off
  Matrix6d covariance = Matrix6d::Zero();  // of that
  double freedom = 30.0;                   // degrees of freedom of the t distribution that its tails have
  double field_mm = 0.0;                   // the smooth field's size over firm skin
  double reach_mm = 0.0;                   // and its reach
  // The live face's size against the scan's, less one, and its standard error: a seventh unknown, fitted
  // beside the pose without a prior on the scan's scale. Of cameras calibrated with a square of the wrong
  // size, or of a scanner's gradients. The pose does not follow it.
  double scale = 0.0, scale_sigma = 0.0;
};

/// What a pose is off (turn rad, shift mm, about the pivot), by the working covariance alone.
Vector6d poseError(const std::vector<SkinPatch>& patches, const anatomy::FaceRegions& regions,
                   const Eigen::Vector3d& pivot_mri_mm);

/// The same with all that is believed of it. `patches`: about 12 mm; those that their neighbours do not
/// explain within 3 sigma are let go gradually.
PosePosterior posteriorOf(const std::vector<SkinPatch>& patches, const anatomy::FaceRegions& regions,
                          const Eigen::Vector3d& pivot_mri_mm, const MisfitPrior& prior);

}  // namespace facenav::registration
