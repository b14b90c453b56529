#pragma once
// Worn: what a person wears: cap, long hair, clothes. Meshes in Mri, at the seat; cap and hair move with the
// head, clothes with the body.

#include "facenav/room/room_wall.h"
#include "facenav/room/virtual_patient.h"
#include "optics/look.h"

namespace facenav::room {

/// Cap with a visor; `above_brows_mm`: height of its rim over the brows. It is empty without landmarks.
surface::TriangleMesh capMesh(const VirtualPatient& patient, double above_brows_mm);
/// Hair that hangs beside and behind the face down to `below_chin_mm`; it starts `aside_rad` from the front.
/// It is empty without landmarks.
surface::TriangleMesh longHairMesh(const VirtualPatient& patient, double below_chin_mm, double aside_rad);
/// Neck from the collar up into the head.
surface::TriangleMesh neckMesh(const VirtualPatient& patient);
/// Shoulders and chest below the collar.
surface::TriangleMesh clothesMesh(const VirtualPatient& patient);

/// Printed or plain fabric. `turn_deg`: of the pattern.
std::shared_ptr<const Look> makeFabricLook(Pattern pattern, double period_mm, double albedo, double contrast,
                                           double turn_deg);
/// Combed strands.
std::shared_ptr<const Look> makeStrandLook(float albedo);

}  // namespace facenav::room
