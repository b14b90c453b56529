#pragma once
// A GenICam camera (GigE Vision, USB3 Vision) through Aravis.

#include <memory>

#include "facenav/capture/camera.h"

namespace facenav::capture {

std::unique_ptr<Camera> openGenicamCamera(const CameraIdentity& camera);

}  // namespace facenav::capture
