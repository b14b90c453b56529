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
  double bare_share = 0.0;      // share of the points expected on bare skin outside covered patches
  double bare_mm = 0.0;         // median |residual| of the bare points
  double extent_mm = 0.0;       // four sigma of the points near the skin across or up, whichever is smaller
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
  // Turn of the right camera that looks like a usual scale error of scan and calibration.
  double scanner_rad = 0.0;
  // Log likelihood ratio of this person's scan to another's, and the size of the live face over that of the
  // scan at which the face is likeliest.
  double own_log_odds = 0.0, fitting_scale = 1.0;
  double rival_log_odds = 1e9;        // log likelihood ratio of the pose to the best other pose
  bool is_patient_confirmed = false;  // as in AlignmentStart
};

/// Thrown if the cameras are no longer positioned as calibrated: another pose would not help.
class CameraTurned : public Error {
 public:
  using Error::Error;
};

/// `noise_mm`: as in AlignmentStart.
FitEvidence gatherEvidence(const ScalpField& scalp, const PointCloud<Camera>& face,
                           const Eigen::Isometry3d& mri_T_camera, const Covers& covers,
                           const std::vector<Candidate>& rivals, double noise_mm);

/// True if a person's confirmation decides that the scan is of the patient in view.
bool restsOnConfirmation(const FitEvidence& evidence);

/// Checks that it is this face, as far as possible before the pose's error is known. Throws Error("not
/// aligned: ...") naming the first reason; PersonUnclear if nothing else speaks against the fit.
void requireLikeness(const FitEvidence& evidence);

/// Does requireLikeness(), and checks that the observations determine the pose well enough.
void requireTrust(const FitEvidence& evidence);

/// True if a large part of the face is occluded. Points there are not skin, even where they happen to fit.
bool isPartlyCovered(const FitEvidence& evidence);

/// Findings for users that need attention but are no reason to refuse.
std::vector<std::string> cautionsOf(const FitEvidence& evidence);

}  // namespace facenav::registration
