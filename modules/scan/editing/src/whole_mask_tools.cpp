#include "facenav/editing/whole_mask_tools.h"

#include "facenav/volume/mask_morphology.h"
#include "voxel_box.h"

namespace facenav::editing {
namespace {

/// The mask within a box; background outside the grid.
volume::Mask cutOut(const volume::Mask& mask, const VoxelBox& box) {
  volume::Mask part;
  part.grid.mri_from_voxel = mask.grid.mri_from_voxel * Eigen::Translation3d(box.low.cast<double>().matrix());
  for (int a = 0; a < 3; ++a) part.grid.size[a] = box.high[a] - box.low[a] + 1;
  part.voxels.resize(part.grid.count());
  for (int k = 0; k < part.grid.size[2]; ++k)
    for (int j = 0; j < part.grid.size[1]; ++j)
      std::copy_n(&mask.voxels[mask.grid.index(box.low[0], box.low[1] + j, box.low[2] + k)],
                  part.grid.size[0], &part.voxels[part.grid.index(0, j, k)]);
  return part;
}

/// The voxels at which `part` differs from the mask.
MaskChange toPart(const volume::Mask& mask, const volume::Mask& part, const VoxelBox& box) {
  MaskChange change;
  for (int k = 0; k < part.grid.size[2]; ++k)
    for (int j = 0; j < part.grid.size[1]; ++j) {
      const std::size_t row = mask.grid.index(box.low[0], box.low[1] + j, box.low[2] + k);
      const std::size_t part_row = part.grid.index(0, j, k);
      for (int i = 0; i < part.grid.size[0]; ++i)
        if ((mask.voxels[row + i] != 0) != (part.voxels[part_row + i] != 0))
          change.voxels.push_back(std::uint32_t(row + i));
    }
  return change;
}

/// One pass of 1-2-1 along each axis (variance 1/2 voxel^2); voxels on the rim of the box are left unchanged.
void averageOnce(std::vector<std::uint16_t>& values, const std::array<int, 3>& n) {
  const std::array<std::size_t, 3> stride{1, std::size_t(n[0]), std::size_t(n[0]) * n[1]};
  std::vector<std::uint16_t> from;
  for (int a = 0; a < 3; ++a) {
    from = values;
    for (std::size_t v = stride[a]; v + stride[a] < from.size(); ++v)
      values[v] = std::uint16_t((from[v - stride[a]] + 2 * from[v] + from[v + stride[a]] + 2) / 4);
  }
}

}  // namespace

MaskChange smooth(const volume::Mask& mask, double sigma_mm, const std::optional<Ball>& within) {
  const double sigma_voxels = sigma_mm / mask.grid.spacing_mm().mean();
  const int passes = std::clamp(int(std::lround(2 * sigma_voxels * sigma_voxels)), 1, 50);
  const VoxelBox box =
      within ? boxAround(mask.grid, Eigen::AlignedBox3d(within->centre.mm), within->radius_mm + passes)
             : boxOf(mask, passes + 1);
  if (box.isEmpty()) return {};
  volume::Mask part = cutOut(mask, box);
  std::vector<std::uint16_t> values(part.voxels.size());
  for (std::size_t v = 0; v < values.size(); ++v) values[v] = part.voxels[v] ? 4096 : 0;
  for (int pass = 0; pass < passes; ++pass) averageOnce(values, part.grid.size);
  for (std::size_t v = 0; v < values.size(); ++v) part.voxels[v] = values[v] >= 2048;
  MaskChange change = toPart(mask, part, box);
  if (!within) return change;
  const auto is_outside = [&](std::uint32_t v) {
    const int row = mask.grid.size[0], column = mask.grid.size[1];
    const Eigen::Vector3d at(v % row, v / row % column, v / row / column);
    return (mask.grid.mri_from_voxel * at - within->centre.mm).norm() > within->radius_mm;
  };
  change.voxels.erase(std::remove_if(change.voxels.begin(), change.voxels.end(), is_outside),
                      change.voxels.end());
  return change;
}

MaskChange fillHoles(const volume::Mask& mask) {
  const VoxelBox box = boxOf(mask, 1);
  if (box.isEmpty()) return {};
  return toPart(mask, volume::fillHoles(cutOut(mask, box)), box);
}

}  // namespace facenav::editing
