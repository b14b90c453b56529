#include "facenav/anatomy/lateral_landmarks.h"

#include <algorithm>
#include <cmath>

namespace facenav::anatomy {
namespace {

using Eigen::Vector3d;

Vector3d onFront(const SkinRelief& front, double x_mm, double z_mm) {
  return {x_mm, front.at(x_mm, z_mm).value_or(0), z_mm};
}

/// The hollow between the nose's bridge and the eyeball, in the row where it is deepest relative to both.
MaybePoint innerCorner(const SkinRelief& front, const Vector3d& nasion, int side) {
  constexpr double kNearest_mm = 9, kFurthest_mm = 26, kLid_mm = 36;
  MaybePoint best;
  double deepest_mm = 0.4;
  for (double z = nasion.z() - 20; z <= nasion.z() + 4; z += 0.5) {
    const auto bridge = front.at(0.0, z);
    if (!bridge) continue;
    for (double x = kNearest_mm; x <= kFurthest_mm; x += 0.5) {
      const auto here = front.at(side * x, z);
      if (!here) continue;
      double lid = -1e6, before = 1e6;
      for (double further = x; further <= kLid_mm; further += 0.5)
        lid = std::max(lid, front.at(side * further, z).value_or(-1e6));
      for (double nearer = kNearest_mm; nearer < x; nearer += 0.5)
        before = std::min(before, front.at(side * nearer, z).value_or(1e6));
      const double depth_mm = std::min(lid, *bridge) - *here;
      if (before >= *here && depth_mm > deepest_mm) deepest_mm = depth_mm, best = onFront(front, side * x, z);
    }
  }
  return best;
}

/// The place beside the inner corner where the closed lid lies furthest to the front. nullopt if it is an end
/// of the search: brow or cheek then hide it.
MaybePoint lidCentre(const SkinRelief& front, const Vector3d& inner, int side) {
  constexpr double kNearest_mm = 7, kFurthest_mm = 26;
  double most_mm = -1e6, at_mm = 0;
  for (double x = kNearest_mm; x <= kFurthest_mm; x += 0.5) {
    double sum_mm = 0;
    for (double z = inner.z() - 6; z <= inner.z() + 2; z += 1)
      sum_mm += front.at(side * (std::abs(inner.x()) + x), z).value_or(-1e6);
    if (sum_mm > most_mm) most_mm = sum_mm, at_mm = x;
  }
  if (at_mm <= kNearest_mm || at_mm >= kFurthest_mm) return std::nullopt;
  return onFront(front, side * (std::abs(inner.x()) + at_mm), inner.z() - 2);
}

/// Morphological closing: fills hollows narrower than twice `radius_mm`.
SkinRelief closed(const SkinRelief& relief, int radius_mm) {
  const auto pass = [&](const SkinRelief& in, int du, int dv, bool is_maximum) {
    SkinRelief out = in;
    for (int row = 0; row < in.rows; ++row)
      for (int column = 0; column < in.columns; ++column) {
        float best = is_maximum ? SkinRelief::kNone : 1e6f;
        for (int k = -radius_mm; k <= radius_mm; ++k) {
          const float h = in.cell(column + k * du, row + k * dv);
          if (h <= SkinRelief::kNone) continue;
          best = is_maximum ? std::max(best, h) : std::min(best, h);
        }
        out.height_mm[std::size_t(row) * in.columns + column] = best >= 1e6f ? SkinRelief::kNone : best;
      }
    return out;
  };
  return pass(pass(pass(pass(relief, 1, 0, true), 0, 1, true), 1, 0, false), 0, 1, false);
}

}  // namespace

EyeLandmarks findEye(const SkinRelief& front, const Vector3d& nasion, int side) {
  EyeLandmarks eye;
  eye.inner_corner = innerCorner(front, nasion, side);
  if (eye.inner_corner) eye.lid_centre = lidCentre(front, *eye.inner_corner, side);
  return eye;
}

MaybePoint findAla(const SkinRelief& front, const Vector3d& subnasale, int side) {
  constexpr double kSteep = 1.0;  // mm of depth per mm sideways: a steep wall, unlike cheek and lip
  MaybePoint best;
  double widest_mm = 0;
  for (double z = subnasale.z() + 3; z <= subnasale.z() + 14; z += 0.5) {
    double steepest = kSteep, at_mm = 0;
    for (double x = 9; x <= 25; x += 0.5) {
      const auto inside = front.at(side * (x - 1), z), outside = front.at(side * (x + 1), z);
      if (inside && outside && (*inside - *outside) / 2 > steepest)
        steepest = (*inside - *outside) / 2, at_mm = x;
    }
    if (at_mm > widest_mm) widest_mm = at_mm, best = onFront(front, side * at_mm, z);
  }
  return best;
}

MaybePoint findTragus(const SkinRelief& lateral, const Vector3d& nasion, int side) {
  constexpr double kLeastHollow_mm = 4, kFront_mm = 14;
  const SkinRelief filled = closed(lateral, 10);
  MaybePoint hollow;
  double deepest_mm = kLeastHollow_mm;
  for (double z = nasion.z() - 60; z <= nasion.z() + 15; z += 1)
    for (double y = nasion.y() - 125; y <= nasion.y() - 70; y += 1) {
      const auto here = lateral.at(y, z), over = filled.at(y, z);
      if (here && over && *over - *here > deepest_mm)
        deepest_mm = *over - *here, hollow = Vector3d(side * *here, y, z);
    }
  if (!hollow) return std::nullopt;
  MaybePoint best;
  double highest_mm = -1e6;
  for (double y = hollow->y() + 2; y <= hollow->y() + kFront_mm; y += 0.5)
    if (const auto here = lateral.at(y, hollow->z()); here && *here > highest_mm)
      highest_mm = *here, best = Vector3d(side * *here, y, hollow->z());
  return best;
}

}  // namespace facenav::anatomy
