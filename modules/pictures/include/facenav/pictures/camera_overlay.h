#pragma once
// Draws the tracking results over the camera images (paper, figures 4, 6 and 9): face box, features, marker
// outline, and the target and coil axis projected into both images by the calibration.

#include <optional>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/core/rgb_image.h"
#include "facenav/guidance/target.h"
#include "facenav/session/navigation_state.h"

namespace facenav::pictures {

struct CameraOverlay {
  RgbImage left, right;  // same size as the camera image; empty if the state has no images
};

/// `target` may be absent. A lost pose is not drawn; text at the top of the image says so.
CameraOverlay drawOverlay(const cameras::StereoRig& rig, const session::NavigationState& state,
                          const std::optional<guidance::Target>& target = std::nullopt);

}  // namespace facenav::pictures
