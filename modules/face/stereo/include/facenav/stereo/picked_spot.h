#pragma once
// PickedSpot: a place that a person picks in one picture of a pair without dots (a finger's tip, a mole). It
// is measured in space by dense stereo (face_cloud.h) in a small part of the pictures around it.

#include <functional>
#include <optional>

#include "facenav/stereo/face_cloud.h"

namespace facenav::stereo {

enum class PictureSide { left, right };

struct PickedSpot {
  Point<Camera> point;  // on the line of sight of the pixel
  double sigma_mm = 0;  // standard deviation of its depth
};

/// `px`: in the picture of `side`. `mayLie` returns true for places on the line of sight that are possible,
/// for example near a known skin; the nearest range of such places is searched. Returns nothing if there is
/// none, if the surface is not measured at the pixel, or if it jumps there (the edge of a finger). Throws
/// Error for a pixel outside the picture, and as measureFace.
std::optional<PickedSpot> measurePickedSpot(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                                            PictureSide side, const Eigen::Vector2d& px,
                                            const std::function<bool(const Point<Camera>&)>& mayLie);

}  // namespace facenav::stereo
