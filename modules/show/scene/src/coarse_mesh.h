#pragma once
// A surface with larger triangles, shown while the view moves. Private to scene.

#include "facenav/surface/triangle_mesh.h"

namespace facenav::scene {

/// Merges the vertices within cubes of `cell_mm`; the new vertex minimises the quadric error (Lindstrom
/// 2000).
surface::TriangleMesh coarsened(const surface::TriangleMesh& mesh, double cell_mm);

/// Returns, for each vertex of `coarse`, the value at the nearest vertex of `fine`. `values`: one per vertex
/// of `fine`.
std::vector<float> valuesAtNearest(const surface::TriangleMesh& fine, const std::vector<float>& values,
                                   const surface::TriangleMesh& coarse);

}  // namespace facenav::scene
