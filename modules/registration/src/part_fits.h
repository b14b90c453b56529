#pragma once
// Fits that leave parts of the face out: hair, a hand, a coil or a mask lifts one region as a whole, and a
// robust loss over everything then settles between face and hair (on scans that end at mid-nose, 5 mm off).
// Each part is fitted alone, then all points from there, closely; the most likely pose wins.

#include "field_fit.h"

namespace facenav::registration {

struct PartFit {
  Eigen::Isometry3d mri_T_camera;
  /// Mean square of (turn rad, shift mm) about the scalp's middle to other poses that parts lead to and that
  /// the face does not rule out; zero when all parts agree.
  Matrix6d doubt = Matrix6d::Zero();
};

/// The best of the poses that `mri_T_camera` (off by up to about 8 mm) leads to. `points`: of the head.
PartFit bestOfParts(const ScalpField& scalp, const PointCloud<Camera>& face, const std::vector<int>& points,
                    const Eigen::Isometry3d& mri_T_camera);

}  // namespace facenav::registration
