#pragma once
// The patient's look: complexion from SkinTexture, pores and freckles from noise in space, and hair.

#include <memory>

#include "face_shape.h"
#include "facenav/room/virtual_patient.h"
#include "optics/look.h"

namespace facenav::room {

/// Makes the look. Keeps references to `patient` and `shape`, which must outlive it.
std::shared_ptr<const Look> makeHeadLook(const VirtualPatient& patient, const FaceShape& shape);

}  // namespace facenav::room
