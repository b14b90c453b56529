#pragma once
// Tests whether the scan has a face for alignment: checks brow, eye sockets and nose at the front of the
// scalp, which may be defaced or cut by the scan's edge.

#include <string>
#include <vector>

#include "scalp/scalp_outline.h"

namespace facenav::surface {

struct FaceCheck {
  bool has_face = false;
  bool has_cut_ear = false;           // true: the last of `findings` describes it
  std::vector<std::string> findings;  // plain words, most important first
};

/// Checks the face. `grid`: the scan's grid, which gives the scan's ends.
FaceCheck checkFace(const TriangleMesh& scalp, const MeshNeighbours& neighbours,
                    const volume::VoxelGrid& grid);

}  // namespace facenav::surface
