#pragma once
// PoseUncertainty: the error of an alignment at any point of the patient, from the pose's covariance. Data
// flow: AlignmentResult -> alignment.json -> guidance, whenever a target is made, moved or renamed.

#include "facenav/geometry/point.h"
#include "facenav/geometry/rigid_transform.h"
#include "facenav/geometry/rotation.h"

namespace facenav::registration {

struct PoseUncertainty {
  Matrix6d covariance = Matrix6d::Zero();  // of (rotation rad, translation mm): left increment in Camera at
                                           // the image of Mri's origin
  double freedom = 30.0;                   // degrees of freedom of the pose error's t distribution

  /// Predicted standard error of `camera_T_mri` at a point of the patient, mm.
  double predictedError_mm(const RigidTransform<Camera, Mri>& camera_T_mri, const Point<Mri>& target) const;
  /// Bound of the error at this point with `probability` (0.95: 95 of 100 alignments), mm.
  double errorBound_mm(const RigidTransform<Camera, Mri>& camera_T_mri, const Point<Mri>& target,
                       double probability = 0.95) const;
};

}  // namespace facenav::registration
