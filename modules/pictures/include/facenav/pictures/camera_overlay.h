#pragma once
// What tracking sees, drawn over the camera images (paper, figures 4, 6 and 9): face box, features, marker
// outline, and the target and coil axis placed into both images through the calibration.

#include <optional>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/core/rgb_image.h"
#include "facenav/guidance/target.h"
#include "facenav/session/navigation_state.h"

namespace facenav::pictures {

struct CameraOverlay {
  RgbImage left, right;  // of the camera's size; empty where the state has no images
};

/// `target` may be absent. A lost pose is not drawn; its absence is stated in words at the image's top.
CameraOverlay drawOverlay(const cameras::StereoRig& rig, const session::NavigationState& state,
                          const std::optional<guidance::Target>& target = std::nullopt);

}  // namespace facenav::pictures
