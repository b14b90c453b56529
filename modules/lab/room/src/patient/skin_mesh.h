#pragma once
// The air/skin boundary of a head MRI as a closed mesh, for the virtual patient. Only the outermost surface;
// each vertex is placed where the smoothed intensity falls most steeply. Independent of module surface on
// purpose: the room's truth must not share the workstation's errors.

#include "facenav/core/task_monitor.h"
#include "facenav/surface/triangle_mesh.h"
#include "facenav/volume/volume.h"

namespace facenav::room {

/// Makes the mesh. Throws Error if the volume contains no head-sized object.
surface::TriangleMesh makeSkinMesh(const volume::Volume& volume, TaskMonitor& monitor);

/// Unit vertex normals: mean of the adjacent triangles, weighted by area.
std::vector<Eigen::Vector3d> vertexNormals(const std::vector<Eigen::Vector3d>& vertices_mm,
                                           const std::vector<Eigen::Vector3i>& triangles);

}  // namespace facenav::room
