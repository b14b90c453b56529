#include "facenav/surface/outside_head.h"

#include "facenav/surface/closest_point.h"

namespace facenav::surface {

double outsideHead_mm(const volume::Mask& head, const ScalpSurface& scalp, const Point<Mri>& p) {
  const Eigen::Vector3d voxel = head.grid.toVoxel(p).array().round();
  const bool is_far = !(voxel.cwiseAbs().maxCoeff() < 1e6);  // too large for int
  if (!is_far) {
    const Eigen::Vector3i at = voxel.cast<int>();
    if (head.grid.contains(at.x(), at.y(), at.z()) && head.at(at.x(), at.y(), at.z())) return 0.0;
  }
  return ClosestPoint(scalp.mesh).nearest(p).distance_mm;
}

}  // namespace facenav::surface
