#include "facenav/volume/slice_plane.h"

#include <cmath>

namespace facenav::volume {
namespace {

struct Box {
  Eigen::Vector3d low, high;
};

Box boundsOf(const VoxelGrid& grid) {
  Box box{Eigen::Vector3d::Constant(1e30), Eigen::Vector3d::Constant(-1e30)};
  for (int c = 0; c < 8; ++c) {
    const Eigen::Vector3d p =
        grid.toMri({double((c & 1) * (grid.size[0] - 1)), double(((c >> 1) & 1) * (grid.size[1] - 1)),
                    double((c >> 2) * (grid.size[2] - 1))})
            .mm;
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

template <class Value, class Sample>
std::vector<Value> samplePlane(const VoxelGrid& grid, const SlicePlane& plane, Sample sample) {
  std::vector<Value> image(std::size_t(plane.width) * plane.height);
  const Eigen::Vector3d start = grid.toVoxel(plane.origin);
  const Eigen::Matrix3d to_voxel = grid.mri_from_voxel.linear().inverse();
  const Eigen::Vector3d du = to_voxel * plane.right.v * plane.spacing_mm,
                        dv = to_voxel * plane.down.v * plane.spacing_mm;
  for (int v = 0; v < plane.height; ++v)
    for (int u = 0; u < plane.width; ++u)
      image[std::size_t(v) * plane.width + u] = sample(start + u * du + v * dv);
  return image;
}

}  // namespace

Eigen::Vector3d SlicePlane::toPixel(const Point<Mri>& p) const {
  const Eigen::Vector3d d = p.mm - origin.mm;
  return {d.dot(right.v) / spacing_mm, d.dot(down.v) / spacing_mm, d.dot(right.v.cross(down.v))};
}

int sliceAxis(const VoxelGrid& grid, const Direction<Mri>& normal) {
  Eigen::Index axis = 0;
  (grid.mri_from_voxel.linear().colwise().normalized().transpose() * normal.v).cwiseAbs().maxCoeff(&axis);
  return int(axis);
}

SliceNumber sliceNumber(const VoxelGrid& grid, const SlicePlane& plane) {
  const int axis = sliceAxis(grid, Direction<Mri>(plane.right.v.cross(plane.down.v)));
  const Point<Mri> middle = plane.toMri(0.5 * (plane.width - 1), 0.5 * (plane.height - 1));
  const int count = grid.size[std::size_t(axis)];
  const long number = std::lround(grid.toVoxel(middle)[axis]) + 1;
  return {number >= 1 && number <= count ? int(number) : 0, count};
}

SlicePlane anatomicalPlane(const VoxelGrid& grid, Anatomical orientation, const Point<Mri>& through,
                           double spacing_mm) {
  const Box box = boundsOf(grid);
  SlicePlane plane;
  plane.spacing_mm = spacing_mm;
  int across = 0, along = 1, normal = 2;
  switch (orientation) {
    case Anatomical::axial:  // right = patient left, down = posterior
      plane.right = Direction<Mri>(-Eigen::Vector3d::UnitX());
      plane.down = Direction<Mri>(-Eigen::Vector3d::UnitY());
      break;
    case Anatomical::coronal:
      plane.right = Direction<Mri>(-Eigen::Vector3d::UnitX());
      plane.down = Direction<Mri>(-Eigen::Vector3d::UnitZ());
      along = 2, normal = 1;
      break;
    case Anatomical::sagittal:  // nose to the left
      plane.right = Direction<Mri>(-Eigen::Vector3d::UnitY());
      plane.down = Direction<Mri>(-Eigen::Vector3d::UnitZ());
      across = 1, along = 2, normal = 0;
      break;
  }
  Eigen::Vector3d origin = box.high;
  origin[normal] = through.mm[normal];
  plane.origin = Point<Mri>(origin);
  plane.width = int(std::floor((box.high[across] - box.low[across]) / spacing_mm)) + 1;
  plane.height = int(std::floor((box.high[along] - box.low[along]) / spacing_mm)) + 1;
  return plane;
}

std::vector<float> sampleSlice(const Volume& volume, const SlicePlane& plane) {
  return samplePlane<float>(volume.grid, plane,
                            [&](const Eigen::Vector3d& ijk) { return sampleLinear(volume, ijk); });
}

std::vector<std::uint8_t> sampleSlice(const Mask& mask, const SlicePlane& plane) {
  return samplePlane<std::uint8_t>(mask.grid, plane, [&](const Eigen::Vector3d& ijk) -> std::uint8_t {
    const int i = int(std::lround(ijk[0])), j = int(std::lround(ijk[1])), k = int(std::lround(ijk[2]));
    return mask.grid.contains(i, j, k) && mask.at(i, j, k);
  });
}

}  // namespace facenav::volume
