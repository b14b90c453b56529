#pragma once
// When a fit is refused, and in which words. A pose that is doubtful must never be handed on.

#include "cloud/bare_skin.h"
#include "misfit_model.h"
#include "search/start_search.h"

namespace facenav::registration {

/// How closely a face lies on the skin at a pose.
struct Closeness {
  std::size_t face_points = 0;  // on a 3 mm grid, with a counterpart that faces the camera, within 15 mm
  double close_fraction = 0.0;  // of these, where bare skin is expected: within 1.5 mm of the skin
  double bare_share = 0.0;      // and not in a patch that something covers
  double bare_mm = 0.0;         // median |residual| of the bare ones
  double median_mm = 0.0, best_third_mm = 0.0;  // quantiles of |residual| of all of them, up to 6 mm
  double extent_mm = 0.0;  // four sigma of the close points across or up the face, the smaller
};

/// What the final fit is judged by.
struct FitEvidence {
  Closeness closeness;
  double predicted_error_mm = 0.0;  // the largest in the brain
  double misfit_mm = 0.0;           // size of the smooth misfit
  double mirror_log_odds = 0.0;     // logarithm of how much likelier the skin is than its mirror image
  bool does_mirror_fit = false;     // where that is the likelier one: as closely as this face would
  // The live face over the scan in size: fitted beside the pose, with its standard error; and the factor at
  // which a face that does not fit would (nothing: at none).
  double scale = 1.0, scale_sigma = 0.0;
  double fitting_scale = 1.0, scale_log_odds = 0.0;
  double rival_log_odds = 1e9;  // of how much likelier the pose is than the best one elsewhere
};

FitEvidence gatherEvidence(const ScalpField& scalp, const PointCloud<Camera>& face,
                           const Eigen::Isometry3d& mri_T_camera, const Covers& covers,
                           const std::vector<Candidate>& rivals);

/// Is it this face, all that is asked before the pose's error is known. Throws Error("not aligned: ...")
/// naming the first reason.
void requireLikeness(const FitEvidence& evidence);

/// The same, and whether the pose is fixed well enough.
void requireTrust(const FitEvidence& evidence);

/// Something hides a good part of the face: what lies there is not skin, even where it happens to fit.
bool isPartlyCovered(const FitEvidence& evidence);

/// What is no reason to refuse, but to look, in plain words.
std::vector<std::string> cautionsOf(const FitEvidence& evidence);

}  // namespace facenav::registration
