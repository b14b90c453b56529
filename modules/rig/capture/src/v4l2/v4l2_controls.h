#pragma once
// Locks the adjustments of a Video4Linux camera (exposure, gain, focus, white balance) and reads them back.

#include <vector>

#include "facenav/capture/camera.h"
#include "v4l2_device.h"

namespace facenav::capture {

/// Turns the automatic adjustments off, sets the values of `settings` (absent: as they are) and reads them
/// back.
std::vector<ControlState> lockControls(V4l2Device& device, const CameraSettings& settings);
/// Turns the automatic adjustments on.
void freeControls(V4l2Device& device);
/// Reads back what was locked. A control that changed since is set once more and read again.
void confirmControls(V4l2Device& device, std::vector<ControlState>& controls);

}  // namespace facenav::capture
