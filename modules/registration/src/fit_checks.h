#pragma once
// When a fit is refused, and in which words. A pose that is doubtful must never be handed on.

#include "misfit_model.h"
#include "start_search.h"

namespace facenav::registration {

/// What the final fit is judged by.
struct FitEvidence {
  std::size_t face_points = 0;  // on a 3 mm grid, with a counterpart that faces the camera, within 15 mm
  double close_fraction = 0.0;  // of these: within 1.5 mm of the skin
  double median_mm = 0.0, best_third_mm = 0.0;  // quantiles of |residual| of face points within 6 mm
  double extent_mm = 0.0;           // four sigma of the close points across or up the face, the smaller
  double predicted_error_mm = 0.0;  // at the middle of the head
  double mirror_z = 0.0;            // how much better the skin fits than its mirror image, in sigmas
  double support = 0.0, rival_support = 0.0;
};

FitEvidence gatherEvidence(const ScalpField& scalp, const PointCloud<Camera>& face,
                           const Eigen::Isometry3d& mri_T_camera, const std::vector<Candidate>& rivals);

/// Throws Error("not aligned: ...") naming the first reason.
void requireTrust(const FitEvidence& evidence);

}  // namespace facenav::registration
