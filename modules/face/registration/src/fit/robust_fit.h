#pragma once
// RobustFit: from a start, known or searched for, to the pose at which most of the face fits closely. The
// misfit model then corrects and judges it.

#include "cloud/bare_skin.h"
#include "part_fits.h"
#include "search/start_search.h"

namespace facenav::registration {

struct RobustFit {
  Eigen::Isometry3d mri_T_camera;
  double limit_mm = 1.5;         // larger residuals are not skin
  std::vector<int> points = {};  // indices of bare points near the head, as dense as measured
  Covers covers;
  // Mean square difference (turn rad, shift mm), about the scalp's middle, to the other poses that parts of
  // the face lead to and that the face does not exclude. Zero if all parts agree.
  Matrix6d doubt = Matrix6d::Zero();
};

/// Starts within a few mm of the skin. Fits parts first (hair, hands), then all points on the fine field.
/// `noise_mm`: as in AlignmentStart.
RobustFit fitFace(const ScalpField& scalp, const PointCloud<Camera>& face,
                  const Eigen::Isometry3d& mri_T_camera, double noise_mm);

/// Points of the cloud near the head and bare, evenly spread over the skin, at most 10 000. The misfit is
/// modelled from them.
std::vector<int> evenPoints(const ScalpField& scalp, const PointCloud<Camera>& face, const RobustFit& fit);

/// Fits from the guess or the hints, without a search. Returns nothing without them, or if they do not lead
/// to the face.
std::optional<RobustFit> fitFromGuess(const ScalpField& scalp, const PointCloud<Camera>& face,
                                      const AlignmentStart& start);

/// Four robust standard deviations of the matches' residuals within `reach_mm`, in 0.6 .. 3 mm, more under
/// much noise.
double inlierLimit_mm(const std::vector<PointMatch>& matches, double reach_mm, double noise_mm = 0.0);

/// Weights 0..1 of points by the residual of the patch of skin around them. Hair, a collar or swollen skin
/// lifts whole patches; noise of single points does not. Residuals beyond `reach_mm` are ignored.
std::vector<float> patchWeights(const std::vector<PointMatch>& matches, double reach_mm,
                                double noise_mm = 0.0);

}  // namespace facenav::registration
