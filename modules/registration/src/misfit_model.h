#pragma once
// The pose and how far it may be off, when the misfit of live skin and MRI is no white noise. Residuals are
// modelled as a random field over the skin (Gaussian process) that any same person's scan may show: an
// offset of the whole skin (where in the dermis the scan's edge lies), a scale of the scan along each axis,
// and a smooth field whose size and reach are estimated from the residuals themselves by restricted maximum
// likelihood (Patterson and Thompson 1971), larger over soft tissue. The pose is the generalised
// least-squares estimate under that field, averaged over what sizes and reaches the residuals leave open;
// its covariance therefore holds the deformations that no residual shows because a pose imitates them.

#include "face_regions.h"
#include "skin_patches.h"

namespace facenav::registration {

/// What is believed about misfit before it is seen, mm (one sigma unless said).
struct MisfitPrior {
  double offset_mm = 0.6;     // of the whole skin along its normals
  double scale = 0.006;       // of the scan, along each axis
  double field_mm = 0.35;     // median size of the smooth field
  double field_spread = 0.8;  // of the size's logarithm
};

struct PoseBelief {
  Vector6d error = Vector6d::Zero();  // (turn rad, shift mm) about the pivot in Mri: what the pose is off
  Matrix6d covariance = Matrix6d::Zero();  // of that
  double freedom = 30.0;                   // degrees of freedom of the t distribution that its tails have
  double field_mm = 0.0;                   // the smooth field's size over firm skin
  double reach_mm = 0.0;                   // and its reach
  // The live face's size against the scan's, less one, and its standard error: a seventh unknown, fitted
  // beside the pose without a prior on the scan's scale. Of cameras calibrated with a square of the wrong
  // size, or of a scanner's gradients. The pose does not follow it.
  double scale = 0.0, scale_sigma = 0.0;
  std::vector<double> surprise;  // per patch: what its neighbours do not explain, in sigmas
};

/// `patches`: about 12 mm; those with surprise beyond 3 sigma are let go gradually.
PoseBelief believe(const std::vector<SkinPatch>& patches, const FaceRegions& regions,
                   const Eigen::Vector3d& pivot_mri_mm, const MisfitPrior& prior);

}  // namespace facenav::registration
