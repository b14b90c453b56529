#pragma once
// Decides when a fit is refused, with which message. A doubtful pose must never be returned.

#include "cloud/bare_skin.h"
#include "facenav/core/error.h"
#include "misfit_model.h"
#include "search/start_search.h"

namespace facenav::registration {

/// How closely a face lies on the skin at a pose.
struct Closeness {
  std::size_t face_points = 0;  // on a 3 mm grid, with a counterpart that faces the camera, within 15 mm
  double close_fraction = 0.0;  // share of the points expected on bare skin within 1.5 mm of it
  double bare_share = 0.0;      // share of these outside covered patches
  double bare_mm = 0.0;         // median |residual| of the bare points
  double median_mm = 0.0, best_third_mm = 0.0;  // quantiles of |residual| up to 6 mm, bare or not
  double extent_mm = 0.0;  // four sigma of the close points across or up the face, whichever is smaller
};

/// Observations that decide about the final fit.
struct FitEvidence {
  Closeness closeness;
  double predicted_error_mm = 0.0;  // the largest in the brain
  double misfit_mm = 0.0;           // size of the smooth misfit
  double mirror_log_odds = 0.0;     // log likelihood ratio of the skin to its mirror image
  bool does_mirror_fit = false;     // if the mirror image is likelier: it fits as closely as a right face
  // Size of the live face over that of the scan, fitted together with the pose, with its standard error.
  double scale = 1.0, scale_sigma = 0.0;
  std::optional<CameraTurn> turn;  // sideways turn of the right camera
  // Size at which a face that does not fit would fit; log odds 0: none.
  double fitting_scale = 1.0, scale_log_odds = 0.0;
  double rival_log_odds = 1e9;  // log likelihood ratio of the pose to the best other pose
};

/// Thrown if the cameras are no longer positioned as calibrated: another pose would not help.
class CameraTurned : public Error {
 public:
  using Error::Error;
};

FitEvidence gatherEvidence(const ScalpField& scalp, const PointCloud<Camera>& face,
                           const Eigen::Isometry3d& mri_T_camera, const Covers& covers,
                           const std::vector<Candidate>& rivals);

/// Checks that it is this face, as far as possible before the pose's error is known. Throws Error("not
/// aligned: ...") naming the first reason.
void requireLikeness(const FitEvidence& evidence);

/// Does requireLikeness(), and checks that the observations determine the pose well enough.
void requireTrust(const FitEvidence& evidence);

/// True if a large part of the face is occluded. Points there are not skin, even where they happen to fit.
bool isPartlyCovered(const FitEvidence& evidence);

/// Findings for users that need attention but are no reason to refuse.
std::vector<std::string> cautionsOf(const FitEvidence& evidence);

}  // namespace facenav::registration
