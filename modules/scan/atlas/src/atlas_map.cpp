#include "facenav/atlas/atlas_map.h"

#include <cmath>

#include "facenav/core/error.h"

namespace facenav::atlas {

AtlasMap::AtlasMap(const Eigen::Affine3d& mri_from_mni, const volume::VoxelGrid& grid,
                   std::vector<Eigen::Vector3f> displacement_mm)
    : mri_from_mni_(mri_from_mni),
      mni_from_mri_(mri_from_mni.inverse()),
      voxel_from_mni_(grid.mri_from_voxel.inverse()),
      grid_(grid),
      displacement_mm_(std::move(displacement_mm)) {
  FACENAV_EXPECT(displacement_mm_.size() == grid_.count(), "one displacement per node of the grid");
}

/// Interpolates linearly between nodes. Beyond the grid the value at its edge is used, so that the map stays
/// continuous and invertible.
Eigen::Vector3d AtlasMap::displacementAt(const Eigen::Vector3d& mni_mm) const {
  if (!mni_mm.allFinite()) return Eigen::Vector3d::Zero();  // no place: the answer is none either
  const Eigen::Array3d last =
      Eigen::Array3i(grid_.size[0], grid_.size[1], grid_.size[2]).cast<double>() - 1.0;
  const Eigen::Array3d at = (voxel_from_mni_ * mni_mm).array().max(0.0).min(last);
  const Eigen::Array3d low = at.floor().min((last - 1.0).max(0.0));
  const Eigen::Array3d part = at - low;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int corner = 0; corner < 8; ++corner) {
    const int c[3] = {corner & 1, corner >> 1 & 1, corner >> 2};
    const double weight =
        (c[0] ? part[0] : 1 - part[0]) * (c[1] ? part[1] : 1 - part[1]) * (c[2] ? part[2] : 1 - part[2]);
    if (weight == 0) continue;
    const auto node = grid_.index(int(low[0]) + c[0], int(low[1]) + c[1], int(low[2]) + c[2]);
    sum += weight * displacement_mm_[node].cast<double>();
  }
  return sum;
}

Point<Mri> AtlasMap::toMri(const Point<Mni>& p) const {
  return Point<Mri>(mri_from_mni_ * (p.mm + displacementAt(p.mm)));
}

Point<Mni> AtlasMap::toMni(const Point<Mri>& p) const {
  constexpr int kMostSteps = 60;
  constexpr double kExact_mm = 0.01;
  const Eigen::Vector3d wanted_mm = mni_from_mri_ * p.mm;
  Eigen::Vector3d x_mm = wanted_mm;
  double damping = 1.0, before_mm = HUGE_VAL;
  for (int step = 0; step < kMostSteps; ++step) {
    const Eigen::Vector3d miss_mm = wanted_mm - (x_mm + displacementAt(x_mm));
    if (miss_mm.norm() < kExact_mm) break;
    if (miss_mm.norm() > before_mm) damping *= 0.5;  // the warp stretches by more than 2 here
    before_mm = miss_mm.norm();
    x_mm += damping * miss_mm;
  }
  return Point<Mni>(x_mm);
}

}  // namespace facenav::atlas
