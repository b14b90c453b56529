#pragma once
// A Video4Linux camera.

#include <memory>

#include "facenav/capture/v4l2_driver.h"

namespace facenav::capture {

std::unique_ptr<Camera> openV4l2Camera(std::shared_ptr<V4l2Driver> driver, const CameraIdentity& camera);

}  // namespace facenav::capture
