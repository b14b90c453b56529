#pragma once
// The robust fit: from a start, known or searched for, to the pose that most of the face fits closely. What
// the misfit model then corrects and judges.

#include "cloud/bare_skin.h"
#include "part_fits.h"
#include "search/start_search.h"

namespace facenav::registration {

struct RobustFit {
  Eigen::Isometry3d mri_T_camera;
  double limit_mm = 1.5;         // residuals beyond are no skin
  std::vector<int> points = {};  // of the cloud: some near the head and bare, as dense as measured
  Covers covers;
  // Mean square of (turn rad, shift mm) about the scalp's middle to other poses that parts of the face lead
  // to and that the face does not rule out; zero when all parts agree.
  Matrix6d doubt = Matrix6d::Zero();
};

/// From within a few mm of the skin: parts first (hair, hands), then all points on the fine field.
RobustFit fitFace(const ScalpField& scalp, const PointCloud<Camera>& face,
                  const Eigen::Isometry3d& mri_T_camera);

/// The cloud's points near the head and bare, spread evenly over the skin, at most 10 000: what the misfit is
/// modelled from.
std::vector<int> evenPoints(const ScalpField& scalp, const PointCloud<Camera>& face, const RobustFit& fit);

/// From the guess or the hints, without a search; nothing where there are none or they lead nowhere.
std::optional<RobustFit> fitFromGuess(const ScalpField& scalp, const PointCloud<Camera>& face,
                                      const AlignmentStart& start);

/// Four robust standard deviations of the matches' residuals within `reach_mm`, in 0.6 .. 3 mm.
double inlierLimit_mm(const std::vector<PointMatch>& matches, double reach_mm);

/// Weights 0..1 of points by how well the patch of skin around them fits as a whole: hair, a collar or
/// swollen skin lifts whole patches, noise does not. Residuals beyond `reach_mm` do not count.
std::vector<float> patchWeights(const std::vector<PointMatch>& matches, double reach_mm);

}  // namespace facenav::registration
