#pragma once
// A surface with larger triangles, for display while the view moves. Private to scene.

#include "facenav/surface/triangle_mesh.h"

namespace facenav::scene {

/// Vertices within `cell_mm` cubes become one, placed by their quadric errors (Lindstrom 2000).
surface::TriangleMesh coarsened(const surface::TriangleMesh& mesh, double cell_mm);

/// Per vertex of `coarse` the value of the nearest vertex of `fine`, which has one a vertex.
std::vector<float> valuesAtNearest(const surface::TriangleMesh& fine, const std::vector<float>& values,
                                   const surface::TriangleMesh& coarse);

}  // namespace facenav::scene
