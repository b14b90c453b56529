#pragma once
// A folder of numbered pictures as a camera.

#include <memory>

#include "facenav/capture/camera.h"

namespace facenav::capture {

/// Opens the folder `camera.address`. Its pictures have the numbers of their names, and the times of these at
/// the configured rate; a missing number is a dropped picture. Throws CameraError: no pictures, a recording
/// of both cameras.
std::unique_ptr<Camera> openFolderCamera(const CameraIdentity& camera);

}  // namespace facenav::capture
