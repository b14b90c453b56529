#pragma once
// The scalp of a case as the skin that faces are aligned to. Mri, mm.

#include "facenav/registration/skin_model.h"
#include "facenav/surface/scalp_surface.h"

namespace facenav::measured_face {

registration::SkinModel skinModel(const surface::ScalpSurface& scalp);

}  // namespace facenav::measured_face
