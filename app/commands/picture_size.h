#pragma once
// Size of live pictures, as typed: "1280x720".

#include <string>

#include "facenav/cameras/stereo_rig.h"

namespace facenav::app {

/// A rig that knows its pictures' size alone. Throws Error: no size.
cameras::StereoRig sizeOnly(const std::string& size);

}  // namespace facenav::app
