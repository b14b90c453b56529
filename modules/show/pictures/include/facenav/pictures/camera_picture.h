#pragma once
// CameraOverlay: the pictures of both cameras with drawings.

#include "facenav/core/rgb_image.h"

namespace facenav::pictures {

struct CameraOverlay {
  RgbImage left, right;  // same size as the camera image; empty if there was none
};

}  // namespace facenav::pictures
