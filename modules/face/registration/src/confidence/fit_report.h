#pragma once
// Computes the result from a robust pose: pose under the misfit model, residuals, inliers,
// covariance. Refuses a pose that cannot be trusted.

#include "fit_checks.h"

namespace facenav::registration {

/// Input of the report of a final pose.
struct FinalFit {
  Eigen::Isometry3d mri_T_camera;
  double limit_mm = 2.0;    // smaller residuals are inliers
  PosePosterior posterior;  // covariance of the pose
};

/// Refines `pose` by one step of generalised least squares over patches of the skin, under a working
/// covariance (misfit_model.h): neighbours share their misfit, and a common offset and the scan's scale have
/// little influence. Takes a millisecond; a plain sum of robust residuals has a tenth more error. Throws
/// Error("not aligned: ...") if too little skin is left.
Eigen::Isometry3d leastSquares(const ScalpField& scalp, const FieldFitter& points,
                               const Eigen::Isometry3d& pose, double limit_mm);

/// Corrects `pose` by the misfit model of the `points`. The covariance includes the cloud's own error and the
/// turn of a camera (of `start`: sight, right).
FinalFit correct(const ScalpField& scalp, const PointCloud<Camera>& face, const std::vector<int>& points,
                 const Eigen::Isometry3d& pose, double limit_mm, const AlignmentStart& start);

/// Computes the covariance of the unchanged `pose` (for a method that does not model misfit).
FinalFit judge(const ScalpField& scalp, const PointCloud<Camera>& face, const std::vector<int>& points,
               const Eigen::Isometry3d& pose, double limit_mm);

/// Throws Error("not aligned: ...") if the fit is doubtful. `closest`: the pose before the misfit model, at
/// which the skins lie closest; the model may put one skin outside the other everywhere. `covers`,
/// `evidence`: as found at `closest`.
AlignmentResult report(const ScalpField& scalp, const PointCloud<Camera>& face, FinalFit fit,
                       const Eigen::Isometry3d& closest, const Covers& covers, FitEvidence evidence,
                       const AlignmentStart& start = {});

/// Throws Error("not aligned: ...") before any fit: no skin, a defaced scan, too few points.
void requireMaterial(const ScalpField& scalp, const PointCloud<Camera>& face);

}  // namespace facenav::registration
