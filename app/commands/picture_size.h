#pragma once
// Size of live pictures, as typed: "1280x720".

#include <string>

#include "facenav/cameras/stereo_rig.h"

namespace facenav::app {

/// Makes a rig that contains only the size of its pictures. Throws Error if `size` is none.
cameras::StereoRig sizeOnly(const std::string& size);

}  // namespace facenav::app
