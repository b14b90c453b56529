#pragma once
// The voxels within a closed mesh.

#include "facenav/surface/triangle_mesh.h"
#include "facenav/volume/volume.h"

namespace facenav::efield {

/// Axis-aligned grid of cubic voxels around a mesh, with a margin.
volume::VoxelGrid gridAround(const surface::TriangleMesh& mesh, double spacing_mm, double margin_mm);

/// Sets the voxels of an axis-aligned grid whose centre lies within a closed mesh that lies in the grid.
volume::Mask solidMask(const surface::TriangleMesh& mesh, const volume::VoxelGrid& grid);

}  // namespace facenav::efield
