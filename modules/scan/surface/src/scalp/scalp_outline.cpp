#include "scalp_outline.h"

#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "facenav/core/grouped.h"
#include "facenav/volume/for_slices.h"
#include "facenav/volume/vtk_image.h"
#include "mesh/mesh_polydata.h"

namespace facenav::surface {
namespace {

using volume::Mask;
using volume::VoxelGrid;

std::vector<float> gaussianKernel(double sigma_voxels) {
  const int radius = std::max(1, int(std::ceil(3 * sigma_voxels)));
  std::vector<float> kernel(2 * radius + 1);
  float sum = 0;
  for (int r = -radius; r <= radius; ++r)
    sum += kernel[r + radius] = float(std::exp(-0.5 * r * r / (sigma_voxels * sigma_voxels)));
  for (float& weight : kernel) weight /= sum;
  return kernel;
}

/// Blurring along one axis, sampled at `count` places, evenly from the first to the last voxel.
struct Block {
  std::array<int, 3> size;
  std::vector<float> values;
};

/// A place along the axis that is mixed into a sample.
struct Tap {
  float weight;
  std::size_t source;
};

/// Taps of all `count` samples of a line of `n` values, an equal number each.
std::vector<Tap> tapsAlong(int n, int count, double sigma_voxels) {
  const std::vector<float> kernel = gaussianKernel(sigma_voxels);
  const int radius = int(kernel.size()) / 2;
  const double step = count > 1 ? double(n - 1) / (count - 1) : 0.0;
  std::vector<Tap> taps;
  for (int c = 0; c < count; ++c) {
    const double at = c * step;
    const int low = std::min(int(at), std::max(0, n - 2));
    const float fraction = float(at - low);
    for (int r = -radius; r <= radius + 1; ++r)
      taps.push_back({(r <= radius ? kernel[r + radius] * (1 - fraction) : 0.f) +
                          (r > -radius ? kernel[r - 1 + radius] * fraction : 0.f),
                      std::size_t(std::clamp(low + r, 0, n - 1))});
  }
  return taps;
}

template <class Value>
Block blurAndSample(const std::array<int, 3>& size, const std::vector<Value>& values, int axis, int count,
                    double sigma_voxels) {
  const int n = size[axis];
  Block out{size, {}};
  out.size[axis] = count;
  out.values.assign(std::size_t(out.size[0]) * out.size[1] * out.size[2], 0.f);
  std::size_t inner = 1;
  int outer = 1;
  for (int a = 0; a < axis; ++a) inner *= size[a];
  for (int a = axis + 1; a < 3; ++a) outer *= size[a];
  const std::vector<Tap> taps = tapsAlong(n, count, sigma_voxels);
  const std::size_t taps_a_place = taps.size() / std::size_t(count);
  volume::forSlices(outer * count, [&](int place) {
    const std::size_t o = std::size_t(place / count), c = std::size_t(place % count);
    float* to = &out.values[std::size_t(place) * inner];
    for (std::size_t t = c * taps_a_place; t < (c + 1) * taps_a_place; ++t) {
      const Value* from = &values[(o * n + taps[t].source) * inner];
      if (inner == 1)
        *to += taps[t].weight * float(*from);
      else
        for (std::size_t i = 0; i < inner; ++i) to[i] += taps[t].weight * float(from[i]);
    }
  });
  return out;
}

std::vector<bool> largeParts(const TriangleMesh& mesh) {
  const MeshNeighbours neighbours = neighboursOf(mesh);
  const int n = int(mesh.vertices_mm.size());
  std::vector<int> part(n, -1), size;
  std::vector<int> queue;
  for (int v = 0; v < n; ++v) {
    if (part[v] >= 0) continue;
    part[v] = int(size.size());
    queue.assign(1, v);
    for (std::size_t q = 0; q < queue.size(); ++q)
      for (int e = neighbours.first[queue[q]]; e < neighbours.first[queue[q] + 1]; ++e)
        if (part[neighbours.all[e]] < 0)
          part[neighbours.all[e]] = part[v], queue.push_back(neighbours.all[e]);
    size.push_back(int(queue.size()));
  }
  std::vector<bool> keep(n);
  for (int v = 0; v < n; ++v) keep[v] = size[part[v]] * 20 >= n;
  return keep;
}

}  // namespace

MeshNeighbours neighboursOf(const TriangleMesh& mesh) {
  const std::size_t n = mesh.vertices_mm.size();
  std::vector<std::pair<int, int>> edges;
  edges.reserve(mesh.triangles.size() * 6);
  for (const auto& t : mesh.triangles)
    for (int c = 0; c < 3; ++c) {
      edges.emplace_back(t[c], t[(c + 1) % 3]);
      edges.emplace_back(t[(c + 1) % 3], t[c]);
    }
  const Grouped all = groupedByOwner(edges, n);
  MeshNeighbours out;
  out.first.assign(n + 1, 0);
  out.on_border.assign(n, false);
  for (std::size_t v = 0; v < n; ++v) {
    for (int e = all.first[v]; e < all.first[v + 1];) {
      int same = e;
      while (same < all.first[v + 1] && all.all[std::size_t(same)] == all.all[std::size_t(e)]) ++same;
      const int other = all.all[std::size_t(e)];
      out.all.push_back(other);
      if (same - e == 1) out.on_border[v] = out.on_border[std::size_t(other)] = true;
      e = same;
    }
    out.first[v + 1] = int(out.all.size());
  }
  return out;
}

TriangleMesh subMesh(const TriangleMesh& mesh, const std::vector<bool>& keep) {
  TriangleMesh out;
  std::vector<int> renumbered(mesh.vertices_mm.size(), -1);
  for (std::size_t v = 0; v < keep.size(); ++v) {
    if (!keep[v]) continue;
    renumbered[v] = int(out.vertices_mm.size());
    out.vertices_mm.push_back(mesh.vertices_mm[v]);
    if (!mesh.normals.empty()) out.normals.push_back(mesh.normals[v]);
  }
  for (const auto& t : mesh.triangles)
    if (keep[t[0]] && keep[t[1]] && keep[t[2]])
      out.triangles.emplace_back(renumbered[t[0]], renumbered[t[1]], renumbered[t[2]]);
  return out;
}

TriangleMesh outlineOf(const Mask& head, double spacing_mm, double blur_mm) {
  const Eigen::Vector3d voxel_mm = head.grid.spacing_mm();
  Block block;
  VoxelGrid grid = head.grid;
  for (int a = 2; a >= 0; --a) {
    const int n = head.grid.size[a];
    const int count = std::max(2, int(std::lround((n - 1) * voxel_mm[a] / spacing_mm)) + 1);
    const double sigma_voxels = blur_mm / voxel_mm[a];
    block = a == 2 ? blurAndSample(head.grid.size, head.voxels, a, count, sigma_voxels)
                   : blurAndSample(block.size, block.values, a, count, sigma_voxels);
    grid.size[a] = count;
    grid.mri_from_voxel.linear().col(a) =
        head.grid.mri_from_voxel.linear().col(a) * (double(n - 1) / (count - 1));
  }
  const auto image = volume::toVtkImage(volume::Volume{grid, std::move(block.values), {}, {}});
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0.5);
  contour->ComputeNormalsOff();
  contour->ComputeGradientsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  TriangleMesh mesh = toTriangleMesh(*contour->GetOutput());
  for (auto& vertex : mesh.vertices_mm) vertex = grid.mri_from_voxel * vertex;
  // The mask decreases outwards. VTK orients contours with normals down the gradient for a right-handed grid.
  if (grid.mri_from_voxel.linear().determinant() < 0)
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  mesh.normals = vertexNormals(mesh);
  mesh = subMesh(mesh, largeParts(mesh));
  return mesh;
}

}  // namespace facenav::surface
