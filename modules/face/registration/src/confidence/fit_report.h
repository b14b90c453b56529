#pragma once
// From a robust pose to the result: pose under the misfit model, residuals, inliers, covariance. Refuses a
// pose that cannot be trusted.

#include "fit_checks.h"

namespace facenav::registration {

/// Input of the report of a final pose.
struct FinalFit {
  Eigen::Isometry3d mri_T_camera;
  double limit_mm = 2.0;    // smaller residuals are inliers
  PosePosterior posterior;  // covariance of the pose
};

/// `pose` after one step of generalised least squares over patches of the skin, under a working covariance
/// (misfit_model.h): neighbours share their misfit, a common offset and the scan's scale have little
/// influence. Takes a millisecond; a plain sum of robust residuals has a tenth more error. Throws Error("not
/// aligned: ...") where too little skin is left.
Eigen::Isometry3d leastSquares(const ScalpField& scalp, const FieldFitter& points,
                               const Eigen::Isometry3d& pose, double limit_mm);

/// `pose` corrected by the misfit model of the `points`, with its covariance, which includes that of the
/// cloud's own error, and the turn of a camera (of `start`: sight, right).
FinalFit correct(const ScalpField& scalp, const PointCloud<Camera>& face, const std::vector<int>& points,
                 const Eigen::Isometry3d& pose, double limit_mm, const AlignmentStart& start);

/// The covariance of `pose` unchanged (for a method that does not model misfit).
FinalFit judge(const ScalpField& scalp, const PointCloud<Camera>& face, const std::vector<int>& points,
               const Eigen::Isometry3d& pose, double limit_mm);

/// Throws Error("not aligned: ...") when the fit is doubtful. `closest`: the pose before the misfit model, at
/// which the skins lie closest; the model may put one skin outside the other everywhere. `covers`,
/// `evidence`: as found at `closest`.
AlignmentResult report(const ScalpField& scalp, const PointCloud<Camera>& face, const FinalFit& fit,
                       const Eigen::Isometry3d& closest, const Covers& covers, FitEvidence evidence,
                       const std::optional<TurnableCamera>& right = {});

/// Refuses before any fit: no skin, a defaced scan, too few points. Throws Error("not aligned: ...").
void requireMaterial(const ScalpField& scalp, const PointCloud<Camera>& face);

}  // namespace facenav::registration
