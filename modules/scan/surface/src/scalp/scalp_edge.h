#pragma once
// Moves a mesh onto the skin's outer edge. The volume's profile along each vertex's normal is averaged with
// those of its neighbours (only along the surface, so the edge is not blurred). The outermost significant
// maximum of its slope is the skin. Bright fat below a dark dermis has a steeper edge 1-3 mm deeper: it is
// ignored, even where both merge.

#include <vector>

#include "scalp_outline.h"

namespace facenav::surface {

struct EdgeSearch {
  double inwards_mm = 4.0, outwards_mm = 3.0;  // search distance from the vertex
  double slope_sigma_mm = 0.6;                 // sigma of the Gaussian derivative that measures the slope
  int rings = 3;                               // rings of neighbours averaged
  double stiffness = 1.0;      // stiffness of the offsets along the surface; a clear edge has weight 1
  bool is_air_erased = false;  // true: the edges' outer tails carry no information
};

/// Moves the vertices along their normals onto the edge and recomputes the normals. Vertices stay within the
/// grid.
void moveOntoEdge(TriangleMesh& mesh, const MeshNeighbours& neighbours, const volume::Volume& volume,
                  const EdgeSearch& search);

}  // namespace facenav::surface
