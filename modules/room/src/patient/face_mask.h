#pragma once
// A surgical mask: cloth drawn over nose bridge, cheeks and chin, a few millimetres off the skin, in the
// patient's Mri.

#include "facenav/room/virtual_patient.h"
#include "optics/look.h"

namespace facenav::room {

/// Open mesh; empty where the patient has no landmarks to lay it on.
surface::TriangleMesh faceMask(const VirtualPatient& patient);

/// Pale cloth with pleats across.
std::shared_ptr<const Look> makeClothLook();

}  // namespace facenav::room
