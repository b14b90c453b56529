#include "facenav/editing/brush.h"

#include <algorithm>

#include "voxel_box.h"

namespace facenav::editing {
namespace {

/// Vector from p to the nearest point of the path.
Eigen::Vector3d awayFrom(const BrushPath& path, const Eigen::Vector3d& p) {
  const Eigen::Vector3d along = path.to.mm - path.from.mm;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0 ? std::clamp((p - path.from.mm).dot(along) / length2, 0.0, 1.0) : 0.0;
  return p - path.from.mm - t * along;
}

template <class Wanted>
MaskChange painted(const volume::Mask& mask, const BrushPath& path, const Brush& brush, bool is_brain,
                   Wanted&& is_wanted) {
  Eigen::AlignedBox3d box(path.from.mm);
  box.extend(path.to.mm);
  const double half_mm = brush.slice_normal ? halfThickness_mm(mask.grid, brush.slice_normal->v) : 0;
  const double reach2 = brush.radius_mm * brush.radius_mm;
  MaskChange change;
  forVoxelsNear(mask.grid, box, brush.radius_mm, [&](std::size_t v, const Eigen::Vector3d& p) {
    if ((mask.voxels[v] != 0) == is_brain) return;
    Eigen::Vector3d away = awayFrom(path, p);
    if (brush.slice_normal) {
      const double off_mm = away.dot(brush.slice_normal->v);
      if (off_mm < -half_mm || off_mm >= half_mm) return;
      away -= off_mm * brush.slice_normal->v;
    }
    if (away.squaredNorm() <= reach2 && is_wanted(v)) change.voxels.push_back(std::uint32_t(v));
  });
  return change;
}

}  // namespace

MaskChange paint(const volume::Mask& mask, const BrushPath& path, const Brush& brush, bool is_brain) {
  return painted(mask, path, brush, is_brain, [](std::size_t) { return true; });
}

MaskChange paintWithin(const volume::Mask& mask, const volume::Volume& volume, const ValueRange& range,
                       const BrushPath& path, const Brush& brush, bool is_brain) {
  return painted(mask, path, brush, is_brain,
                 [&](std::size_t v) { return range.contains(volume.voxels[v]); });
}

}  // namespace facenav::editing
