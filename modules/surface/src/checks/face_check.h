#pragma once
// Is there a face to align to? Looks at the front of the scalp: brow, eye sockets, nose; defaced or cut by
// the scan's end.

#include <string>
#include <vector>

#include "scalp/scalp_outline.h"

namespace facenav::surface {

struct FaceCheck {
  bool has_face = false;
  std::vector<std::string> findings;  // plain words, most important first
};

/// `grid`: of the scan, for where it ends.
FaceCheck checkFace(const TriangleMesh& scalp, const MeshNeighbours& neighbours,
                    const volume::VoxelGrid& grid);

}  // namespace facenav::surface
