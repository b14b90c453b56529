#pragma once
// The outline of the head mask as a smooth mesh: start of the search for the skin's edge.

#include <vector>

#include "facenav/surface/triangle_mesh.h"
#include "facenav/volume/volume.h"

namespace facenav::surface {

/// Outline of `head`: half-level of the blurred mask on a grid of about `spacing_mm`, in Mri, outward; open
/// where the mask meets the grid's end. Parts smaller than a twentieth of the whole are dropped.
TriangleMesh outlineOf(const volume::Mask& head, double spacing_mm, double blur_mm);

/// Neighbours of each vertex along edges, and whether it lies on an open edge.
struct MeshNeighbours {
  std::vector<int> first;  // neighbours of v: all[first[v]] .. all[first[v + 1] - 1]
  std::vector<int> all;
  std::vector<bool> on_border;
};
MeshNeighbours neighboursOf(const TriangleMesh& mesh);

/// Drops the vertices where `keep` is false, and their triangles.
TriangleMesh subMesh(const TriangleMesh& mesh, const std::vector<bool>& keep);

}  // namespace facenav::surface
