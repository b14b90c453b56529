#pragma once
// CameraOverlay: both cameras' pictures with something drawn over them.

#include "facenav/core/rgb_image.h"

namespace facenav::pictures {

struct CameraOverlay {
  RgbImage left, right;  // same size as the camera image; empty if there was none
};

}  // namespace facenav::pictures
