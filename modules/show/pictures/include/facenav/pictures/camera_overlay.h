#pragma once
// Draws the tracking results over the camera images (paper, figures 4, 6 and 9): face box, features, marker
// outline, and the target and coil axis projected into both images by the calibration.

#include <optional>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/guidance/target.h"
#include "facenav/pictures/aligned_skin.h"
#include "facenav/session/navigation_state.h"

namespace facenav::pictures {

/// What to draw for the visual check of the alignment: the MRI's skin, the point of the coil that is held to
/// the face, and the spot that a person picked, if there is one.
struct AlignmentShown {
  std::shared_ptr<const AlignedSkin> skin;  // not null
  Point<Coil> tip;
  std::optional<Point<Mri>> spot = {};
};

/// Draws the results of one frame. `target` may be absent. A lost pose is not drawn; a text at the top of the
/// image reports it. With `alignment`, the MRI's skin and the coil's tip replace the face's features.
CameraOverlay drawOverlay(const cameras::StereoRig& rig, const session::NavigationState& state,
                          const std::optional<guidance::Target>& target = std::nullopt,
                          const std::optional<AlignmentShown>& alignment = std::nullopt);

}  // namespace facenav::pictures
