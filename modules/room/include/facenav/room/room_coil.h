#pragma once
// RoomCoil: the figure-8 coil of the virtual room with its printed marker. Frames: Coil and Marker of
// FORMATS.md.

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

/// Mounts the marker's plate on the back of the coil so that it faces the cameras (`mri_T_view`'s +z is the
/// cameras' viewing direction, +y down in their image, in Mri) while the coil is at `target`.
RoomCoil mountedCoil(const RigidTransform<Mri, frames::Target>& target, const Eigen::Matrix3d& mri_R_view);

/// The coil without its marker plate, Coil frame, mm: two wings, housing, handle, stem to the plate.
surface::TriangleMesh coilMesh(const RoomCoil& coil);

}  // namespace facenav::room
