#pragma once
// From a final pose to what the caller gets: residuals, inliers, covariance; refused when it cannot be
// trusted.

#include "fit_checks.h"

namespace facenav::registration {

struct FinalFit {
  Eigen::Isometry3d mri_T_camera;
  double limit_mm = 2.0;  // residuals within are inliers
};

double median(std::vector<double> values);

/// Weights 0..1 of points by how well the patch of skin around them fits as a whole: hair, a collar or
/// swollen skin lifts whole patches, noise does not. Residuals beyond `reach_mm` do not count.
std::vector<double> patchWeights(const std::vector<PointMatch>& matches, double reach_mm);

/// Four robust standard deviations of the matches' residuals within `reach_mm`, in 0.6 .. 3 mm.
double inlierLimit_mm(const std::vector<PointMatch>& matches, double reach_mm);

/// Throws Error("not aligned: ...") when the fit is doubtful.
AlignmentResult report(const SkinField& skin, const PointCloud<Camera>& face, const FinalFit& fit,
                       const std::vector<Candidate>& rivals);

/// The first reason not to try at all: no skin, a defaced scan, hardly any points. Throws Error("not aligned:
/// ...").
void requireMaterial(const SkinModel& skin, const PointCloud<Camera>& face);

}  // namespace facenav::registration
