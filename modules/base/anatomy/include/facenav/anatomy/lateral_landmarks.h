#pragma once
// Landmarks beside the midline, on reliefs of the head (skin_relief.h): inner corners of the eyes,
// lid centres, wings of the nose, tragi.

#include <Eigen/Core>
#include <optional>

#include "facenav/anatomy/skin_relief.h"

namespace facenav::anatomy {

using MaybePoint = std::optional<Eigen::Vector3d>;  // in the head frame, mm; nullopt if not found

struct EyeLandmarks {
  MaybePoint inner_corner, lid_centre;
};
/// Finds inner corner and lid centre of one eye. `front`: the relief smoothed by about 1.5 mm. `side` +1: the
/// patient's right.
EyeLandmarks findEye(const SkinRelief& front, const Eigen::Vector3d& nasion, int side);

/// The outermost point of the nose's wing, at the height of the wings above the nose's base.
MaybePoint findAla(const SkinRelief& front, const Eigen::Vector3d& subnasale, int side);

/// The skin in front of the ear's deepest hollow. `lateral`: the relief seen from that side.
MaybePoint findTragus(const SkinRelief& lateral, const Eigen::Vector3d& nasion, int side);

}  // namespace facenav::anatomy
