#pragma once
// Where the marker's plate stands on the coil: in sight of both cameras while the coil is at its target, as a
// clinic would mount it, and not before the face.

#include "facenav/cameras/stereo_rig.h"
#include "facenav/room/room_coil.h"
#include "facenav/room/room_rig.h"
#include "facenav/room/virtual_patient.h"

namespace facenav::room {

/// The seated patient as the cameras have him.
struct CoilView {
  const cameras::StereoRig& rig;
  RigidTransform<Camera, Room> camera_T_room;
  RigidTransform<Room, Mri> room_T_mri;
};

/// Tries plates behind the coil and beside it, all turned to the cameras, and takes the one of which both
/// cameras see most through small movements of the head, the nearest to the usual place (85 mm behind the
/// coil) among equals.
RoomCoil mountedCoil(const RigidTransform<Mri, frames::Target>& target, const VirtualPatient& patient,
                     const CoilView& view);

}  // namespace facenav::room
