#pragma once
// Finds the face on the front of a head by its likeness to the mean face: the relief of brow, eyes, nose and
// upper lip, each relative to a smooth surface through its surroundings, so that head shape, turn and nod do
// not count. In: a relief in the head's own axes (skin_relief.h). Used by surface's face check: where no
// place is like a face, the face was removed or lies outside the scan.

#include <optional>

#include "facenav/anatomy/skin_relief.h"

namespace facenav::anatomy {

struct FaceMatch {
  double likeness = 0;             // correlation with the mean face, 1: the same form
  double strength = 0;             // height of the relief relative to the mean face's at that size
  double scale = 1;                // size relative to the mean face
  double x_mm = 0, nasion_mm = 0;  // the nasion across and up, in the relief's axes
  double seen_share = 0;           // share of the mean face's area with skin

  /// Height above (or, negative, below) the nasion, in the mean face's mm.
  double aboveNasion_mm(double up_mm) const { return (up_mm - nasion_mm) / scale; }
};

/// The most face-like place of `front`, 45 to 165 mm below `top_mm`, the head's highest point. nullopt if the
/// skin ends above all of them.
std::optional<FaceMatch> findFace(const SkinRelief& front, double top_mm);

/// Root mean square of the relief's detail finer than 5 mm within the given box (in the relief's axes), mm.
/// nullopt where there is too little skin.
std::optional<double> fineRelief_mm(const SkinRelief& front, const Eigen::AlignedBox2d& box_mm);

}  // namespace facenav::anatomy
