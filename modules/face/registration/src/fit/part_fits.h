#pragma once
// Fits that leave parts of the face out. Hair, a hand, a coil or a mask lifts one region as a whole; a robust
// loss over all points then settles between face and hair (5 mm off on scans that end at mid-nose). Each part
// is fitted alone, then all points closely from the pose found. The likeliest poses are kept.

#include "field_fit.h"

namespace facenav::registration {

struct PartFit {
  Eigen::Isometry3d mri_T_camera;
  double log_likelihood = 0.0;
};

/// Poses found from `mri_T_camera` (off by up to about 8 mm), the likeliest first. The others are those that
/// the face does not exclude. `points`: of the head. `noise_mm`: as in AlignmentStart.
std::vector<PartFit> fitParts(const ScalpField& scalp, const PointCloud<Camera>& face,
                              const std::vector<int>& points, const Eigen::Isometry3d& mri_T_camera,
                              double noise_mm);

}  // namespace facenav::registration
