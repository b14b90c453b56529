#include "model/solid_mask.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "facenav/core/parallel_for.h"
#include "facenav/surface/closest_point.h"
#include "facenav/volume/mask_morphology.h"

namespace facenav::efield {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Calls visit(j, k, x) where the line of voxels (j, k) crosses the triangle, in voxels.
template <class Visit>
void forCrossings(const Vector3d corners[3], const Visit& visit) {
  const Vector2d a = corners[0].tail<2>(), b = corners[1].tail<2>(), c = corners[2].tail<2>();
  const double twice_area = cross(b - a, c - a);
  if (twice_area == 0) return;
  const Vector2d low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
  for (int k = int(std::ceil(low.y())); k <= high.y(); ++k)
    for (int j = int(std::ceil(low.x())); j <= high.x(); ++j) {
      const Vector2d p(j, k);
      const double u = cross(c - b, p - b) / twice_area, v = cross(a - c, p - c) / twice_area, w = 1 - u - v;
      if (u >= 0 && v >= 0 && w >= 0)
        visit(j, k, u * corners[0].x() + v * corners[1].x() + w * corners[2].x());
    }
}

}  // namespace

volume::VoxelGrid gridAround(const surface::TriangleMesh& mesh, double spacing_mm, double margin_mm) {
  Eigen::AlignedBox3d box;
  for (const auto& vertex : mesh.vertices_mm) box.extend(vertex);
  volume::VoxelGrid grid;
  grid.mri_from_voxel.linear() *= spacing_mm;
  grid.mri_from_voxel.translation() = box.min().array() - margin_mm;
  for (int axis = 0; axis < 3; ++axis)
    grid.size[std::size_t(axis)] = int(std::ceil((box.sizes()[axis] + 2 * margin_mm) / spacing_mm)) + 1;
  return grid;
}

volume::Mask solidMask(const surface::TriangleMesh& mesh, const volume::VoxelGrid& grid) {
  volume::Mask solid{grid, std::vector<std::uint8_t>(grid.count())};
  // Moves the lines off the mesh's vertices, so that no line runs through an edge.
  const Vector3d off(0, 1.37e-5, 2.91e-5);
  for (const auto& triangle : mesh.triangles) {
    Vector3d corners[3];
    for (int c = 0; c < 3; ++c)
      corners[c] = grid.toVoxel(Point<Mri>(mesh.vertices_mm[std::size_t(triangle[c])])) + off;
    // Each crossing changes the state of all voxels after it.
    forCrossings(corners, [&](int j, int k, double x) {
      const int i = std::max(0, int(std::ceil(x)));
      if (grid.contains(i, j, k)) solid.voxels[grid.index(i, j, k)] ^= 1;
    });
  }
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 1; i < grid.size[0]; ++i)
        solid.voxels[grid.index(i, j, k)] ^= solid.voxels[grid.index(i - 1, j, k)];
  return solid;
}

volume::Volume solidShare(const surface::TriangleMesh& mesh, const volume::Mask& solid, double depth_mm,
                          double blur_mm) {
  volume::Volume share;
  share.grid = solid.grid;
  share.voxels.assign(solid.voxels.begin(), solid.voxels.end());
  const std::vector<float> outside_mm = volume::distanceTo(solid), inside_mm = volume::depthWithin(solid);
  const auto& size = solid.grid.size;
  const double near_mm = blur_mm + depth_mm + solid.grid.spacing_mm().maxCoeff();
  const surface::ClosestPoint surface(mesh);
  parallelRanges(0, size[2], [&](int begin, int end) {
    std::optional<int> near;
    for (int k = begin; k < end; ++k)
      for (int j = 0; j < size[1]; ++j)
        for (int i = 0; i < size[0]; ++i) {
          const std::size_t v = solid.grid.index(i, j, k);
          if (std::max(outside_mm[v], inside_mm[v]) > near_mm) continue;
          const auto place = surface.nearest(solid.grid.toMri(Vector3d(i, j, k)), near);
          near = place.triangle;
          const double here_mm = solid.voxels[v] ? place.distance_mm : -place.distance_mm;
          share.voxels[v] = float(std::clamp(0.5 + 0.5 * (here_mm - depth_mm) / blur_mm, 0.0, 1.0));
        }
  });
  return share;
}

}  // namespace facenav::efield
