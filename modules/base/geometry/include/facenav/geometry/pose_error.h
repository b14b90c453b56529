#pragma once
// PoseError: the difference between an estimated pose and the true one, as reported in the tables.

#include "facenav/geometry/rigid_transform.h"
#include "facenav/geometry/rotation.h"

namespace facenav {
inline namespace geometry {

struct PoseError {
  double rotation_rad = 0.0;    // angle of R_estimated^T R_true
  double translation_mm = 0.0;  // difference of the origins
  double at_point_mm = 0.0;     // difference at the given point (a cortical target, say)
};

/// Error of `estimated` against `truth`. `point` is the point of interest (default: the origin of From).
template <class To, class From>
PoseError poseError(const RigidTransform<To, From>& estimated, const RigidTransform<To, From>& truth,
                    const Point<From>& point = {}) {
  return {rotationAngle(estimated.rotation().transpose() * truth.rotation()),
          (estimated.translation_mm() - truth.translation_mm()).norm(),
          ((estimated * point).mm - (truth * point).mm).norm()};
}

}  // namespace geometry
}  // namespace facenav
