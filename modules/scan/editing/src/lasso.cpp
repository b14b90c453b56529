#include "facenav/editing/lasso.h"

#include "voxel_box.h"

namespace facenav::editing {

bool isInside(const Outline& outline, const Eigen::Vector2d& p) {
  bool is_inside = false;
  for (std::size_t n = 0, before = outline.size() - 1; n < outline.size(); before = n++) {
    const Eigen::Vector2d &a = outline[n], &b = outline[before];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x())
      is_inside = !is_inside;
  }
  return is_inside;
}

MaskChange lasso(const volume::Mask& mask, const volume::SlicePlane& plane, const Outline& outline,
                 bool is_brain) {
  MaskChange change;
  if (outline.size() < 3) return change;
  Eigen::AlignedBox3d box;
  for (const auto& corner : outline) box.extend(plane.toMri(corner.x(), corner.y()).mm);
  const Eigen::Vector3d normal = plane.right.v.cross(plane.down.v);
  const double half_mm = halfThickness_mm(mask.grid, normal);
  forVoxelsNear(mask.grid, box, half_mm, [&](std::size_t v, const Eigen::Vector3d& p) {
    if ((mask.voxels[v] != 0) == is_brain) return;
    const Eigen::Vector3d pixel = plane.toPixel(Point<Mri>(p));
    if (pixel.z() < -half_mm || pixel.z() >= half_mm) return;
    if (isInside(outline, pixel.head<2>())) change.voxels.push_back(std::uint32_t(v));
  });
  return change;
}

}  // namespace facenav::editing
