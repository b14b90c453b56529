#pragma once
// A surgical mask: cloth over nose bridge, cheeks and chin, a few millimetres off the skin, in the patient's
// Mri.

#include "facenav/room/virtual_patient.h"
#include "optics/look.h"

namespace facenav::room {

/// Open mesh of the mask; empty if the patient has no landmarks.
surface::TriangleMesh faceMask(const VirtualPatient& patient);

/// Look of pale cloth with horizontal pleats.
std::shared_ptr<const Look> makeClothLook();

}  // namespace facenav::room
