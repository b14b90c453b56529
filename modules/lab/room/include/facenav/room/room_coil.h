#pragma once
// RoomCoil: the figure-8 coil of the virtual room with its printed marker. Frames: Coil and Marker
// (modules/README.md).

#include <string>

#include "facenav/geometry/rigid_transform.h"
#include "facenav/surface/triangle_mesh.h"

namespace facenav::room {

struct RoomCoil {
  std::string name = "figure-8 70 mm";
  std::string dictionary = "4x4_50";
  int marker_id = 7;
  double marker_size_mm = 60.0;
  RigidTransform<Marker, Coil> marker_T_coil;
};

/// Mesh of two wings, housing and handle, Coil frame, mm.
surface::TriangleMesh coilBodyMesh();
/// Mesh of the body and of the stem that carries the marker's plate, without the plate.
surface::TriangleMesh coilMesh(const RoomCoil& coil);

}  // namespace facenav::room
