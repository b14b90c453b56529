#pragma once
// facenav cameras --latency: camera-to-screen latency, with the terminal as the screen.

#include "context.h"
#include "facenav/capture/camera_backend.h"

namespace facenav::app {

/// Measures the latency: the terminal flashes white and black for about half a minute while the camera films
/// it. Throws Error if the camera does not see it; CameraError.
void measureLatency(const capture::CameraBackends& backends, const capture::CameraIdentity& camera,
                    const capture::CameraSettings& settings, bool is_json);

}  // namespace facenav::app
