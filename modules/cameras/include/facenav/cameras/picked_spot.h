#pragma once
// A place that a person picks in one picture (a finger's tip, a mole), measured in space: its patch is
// searched along the epipolar line of the other picture, then refined without that line (patch_match.h), so
// that the line checks the match.

#include <functional>
#include <optional>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"

namespace facenav::cameras {

enum class PictureSide { left, right };

struct PickedSpot {
  Point<Camera> point;
  double sigma_mm = 0;  // of its depth, one standard deviation, from texture and residual
};

/// `px`: in the picture of `side`. `mayLie` tells which places on the line of sight are searched, say those
/// near a known skin. 8-bit grey pictures of the rig's size. Nothing where the patch has too little texture,
/// fits at no place or at two, or the refined match lies off the epipolar line. Throws Error for a pixel
/// outside.
std::optional<PickedSpot> measurePickedSpot(const StereoRig& rig, const StereoFrame& frame, PictureSide side,
                                            const Eigen::Vector2d& px,
                                            const std::function<bool(const Point<Camera>&)>& mayLie);

}  // namespace facenav::cameras
