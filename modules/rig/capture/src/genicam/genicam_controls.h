#pragma once
// Locks the adjustments of a GenICam camera (exposure, gain, white balance) and reads them back. Focus is set
// at the lens.

#include <vector>

#include "facenav/capture/camera.h"
#include "genicam_call.h"

namespace facenav::capture {

std::vector<ControlState> lockControls(ArvCamera* camera, const CameraSettings& settings);
/// Turns the automatic adjustments on, where the camera has them.
void freeControls(ArvCamera* camera);
/// Sets free running, or the first trigger input of its kind. Throws CameraError refused.
void setTrigger(ArvCamera* camera, Trigger trigger, const std::string& where);

}  // namespace facenav::capture
