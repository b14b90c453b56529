#pragma once
// SkinModel of a case's scalp, to which faces are aligned. Mri, mm.

#include "facenav/registration/skin_model.h"
#include "facenav/surface/scalp_surface.h"

namespace facenav::measured_face {

registration::SkinModel skinModel(const surface::ScalpSurface& scalp);

}  // namespace facenav::measured_face
