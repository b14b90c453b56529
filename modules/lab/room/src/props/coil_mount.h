#pragma once
// Position of the marker's plate on the coil: visible to both cameras while the coil is at its target, as a
// clinic would mount it, and not in front of the face.

#include "facenav/cameras/stereo_rig.h"
#include "facenav/room/room_coil.h"
#include "facenav/room/room_rig.h"
#include "facenav/room/virtual_patient.h"

namespace facenav::room {

/// The seated patient and the cameras.
struct CoilView {
  const cameras::StereoRig& rig;
  RigidTransform<Camera, Room> camera_T_room;
  RigidTransform<Room, Mri> room_T_mri;
};

/// Mounts the marker. Tries plates behind and beside the coil, all facing the cameras. Takes the plate that
/// both cameras see best during small head movements; among equals, the one nearest to the usual position (85
/// mm behind the coil).
RoomCoil mountedCoil(const RigidTransform<Mri, frames::Target>& target, const VirtualPatient& patient,
                     const CoilView& view);

}  // namespace facenav::room
