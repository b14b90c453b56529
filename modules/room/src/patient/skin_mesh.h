#pragma once
// The air/skin boundary of a head MRI as a closed mesh, for the virtual patient: outermost surface only, each
// vertex placed where the smoothed intensity falls most steeply. Written apart from module surface on
// purpose: the room's truth then does not share the workstation's own errors.

#include "facenav/core/task_monitor.h"
#include "facenav/surface/triangle_mesh.h"
#include "facenav/volume/volume.h"

namespace facenav::room {

/// Throws Error when the volume holds no head-sized object.
surface::TriangleMesh makeSkinMesh(const volume::Volume& volume, TaskMonitor& monitor);

/// Unit vertex normals from the triangles around, weighted by area.
std::vector<Eigen::Vector3d> vertexNormals(const std::vector<Eigen::Vector3d>& vertices_mm,
                                           const std::vector<Eigen::Vector3i>& triangles);

}  // namespace facenav::room
