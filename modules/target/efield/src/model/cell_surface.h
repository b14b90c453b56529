#pragma once
// A closed surface with even triangles between the set and the unset voxels of a coarse mask: one vertex per
// cell of eight voxels, moved to the 0.5 level of a finer field (surface nets: Gibson 1998, MICCAI).

#include "facenav/efield/shell_mesh.h"
#include "facenav/volume/volume.h"

namespace facenav::efield {

/// Sets voxels until no two set ones touch at an edge or a corner alone, and no two unset ones: the surface
/// between them is then a manifold. Of several voxels the one with the highest value of `field` is set. The
/// outermost voxels of the mask must be unset.
void joinDiagonals(volume::Mask& coarse, const volume::Volume& field);

/// Surface of a mask after joinDiagonals(). Each vertex stays in its cell, so that no triangles cross.
ShellMesh cellSurface(const volume::Mask& coarse, const volume::Volume& field);

}  // namespace facenav::efield
