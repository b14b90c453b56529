#pragma once
// From a robust pose to what the caller gets: the pose under the misfit model, residuals, inliers,
// covariance; refused when it cannot be trusted.

#include "fit_checks.h"

namespace facenav::registration {

/// What a final pose is reported from.
struct FinalFit {
  Eigen::Isometry3d mri_T_camera;
  double limit_mm = 2.0;    // residuals within are inliers
  PosePosterior posterior;  // its covariance
};

/// `pose` after one step of generalised least squares over patches of the skin under a working covariance
/// (misfit_model.h): neighbours share their misfit, a whole offset and the scan's scale count little. Takes a
/// millisecond; a plain sum of robust residuals errs by a tenth more. Throws Error("not aligned: ...") where
/// too little skin is left.
Eigen::Isometry3d leastSquares(const ScalpField& scalp, const FieldFitter& points,
                               const Eigen::Isometry3d& pose, double limit_mm);

/// `pose` corrected by what the misfit model says of the `points`, and how far it may still be off.
FinalFit correct(const ScalpField& scalp, const PointCloud<Camera>& face, const std::vector<int>& points,
                 const Eigen::Isometry3d& pose, double limit_mm);

/// The covariance that goes with `pose` as it is (a method that does not model misfit).
FinalFit judge(const ScalpField& scalp, const PointCloud<Camera>& face, const std::vector<int>& points,
               const Eigen::Isometry3d& pose, double limit_mm);

/// Throws Error("not aligned: ...") when the fit is doubtful. `closest`: the pose before the misfit model,
/// where the skins lie closest; the model may hold that one lies outside the other all over. `covers`,
/// `evidence`: as found there.
AlignmentResult report(const ScalpField& scalp, const PointCloud<Camera>& face, const FinalFit& fit,
                       const Eigen::Isometry3d& closest, const Covers& covers, FitEvidence evidence);

/// The first reason not to try at all: no skin, a defaced scan, hardly any points. Throws Error("not aligned:
/// ...").
void requireMaterial(const ScalpField& scalp, const PointCloud<Camera>& face);

}  // namespace facenav::registration
