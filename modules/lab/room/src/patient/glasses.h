#pragma once
// A pair of glasses: two rims, a bridge and temples, in the patient's Mri. The lenses are clear: they neither
// bend nor reflect light.

#include "facenav/room/virtual_patient.h"

namespace facenav::room {

/// Closed mesh of the frame; empty if the patient has no landmarks.
surface::TriangleMesh glassesFrame(const VirtualPatient& patient);

}  // namespace facenav::room
