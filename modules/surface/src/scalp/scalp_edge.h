#pragma once
// Places a mesh on the skin's outer edge: along each vertex's normal the volume's profile is averaged with
// those of the neighbours (along the surface only, so the edge itself is not blurred), and the outermost
// significant maximum of its slope is the skin. Bright fat below a dark dermis has the steeper edge 1-3 mm
// deeper: it is passed over, also where both run together.

#include <vector>

#include "scalp_outline.h"

namespace facenav::surface {

struct EdgeSearch {
  double inwards_mm = 4.0, outwards_mm = 3.0;  // how far from the vertex
  double slope_sigma_mm = 0.6;                 // of the Gaussian whose derivative measures the slope
  int rings = 3;                               // neighbours averaged
  double stiffness = 1.0;  // of the offsets along the surface, against weight 1 of a clear edge
};

/// Moves the vertices along their normals onto the edge; normals are renewed. Vertices stay within the grid.
void moveOntoEdge(TriangleMesh& mesh, const MeshNeighbours& neighbours, const volume::Volume& volume,
                  const EdgeSearch& search);

}  // namespace facenav::surface
