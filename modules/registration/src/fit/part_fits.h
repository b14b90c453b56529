#pragma once
// Fits that leave parts of the face out: hair, a hand, a coil or a mask lifts one region as a whole, and a
// robust loss over everything then settles between face and hair (on scans that end at mid-nose, 5 mm off).
// Each part is fitted alone, then all points from there, closely; the likeliest poses win.

#include "field_fit.h"

namespace facenav::registration {

struct PartFit {
  Eigen::Isometry3d mri_T_camera;
  double log_likelihood = 0.0;
};

/// Where `mri_T_camera` (off by up to about 8 mm) leads to, the likeliest first, and what the face does not
/// rule out beside it. `points`: of the head.
std::vector<PartFit> fitParts(const ScalpField& scalp, const PointCloud<Camera>& face,
                              const std::vector<int>& points, const Eigen::Isometry3d& mri_T_camera);

}  // namespace facenav::registration
