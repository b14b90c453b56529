#pragma once
// The voxels within a closed mesh.

#include "facenav/surface/triangle_mesh.h"
#include "facenav/volume/volume.h"

namespace facenav::efield {

/// Axis-aligned grid of cubic voxels around a mesh, with a margin.
volume::VoxelGrid gridAround(const surface::TriangleMesh& mesh, double spacing_mm, double margin_mm);

/// Sets the voxels of an axis-aligned grid whose centre lies within a closed mesh that lies in the grid.
volume::Mask solidMask(const surface::TriangleMesh& mesh, const volume::VoxelGrid& grid);

/// Share of each voxel that lies at least `depth_mm` deep in the mesh, from its distance to the mesh: 0.5 at
/// that depth, linear within `blur_mm` of it. A mask alone has steps of a voxel, which make terraces of
/// surfaces. `solid`: the mesh's solidMask().
volume::Volume solidShare(const surface::TriangleMesh& mesh, const volume::Mask& solid, double depth_mm,
                          double blur_mm);

}  // namespace facenav::efield
