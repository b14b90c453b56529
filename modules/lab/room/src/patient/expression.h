#pragma once
// Expression: the skin motion of a grimace, as a smooth field of displacements around the patient's
// landmarks. The bridge of the nose and the temples do not move; they carry the head's pose.

#include <Eigen/Core>
#include <vector>

#include "skin_paint.h"

namespace facenav::room {

/// Weights of the grimaces, 0 none .. 1 full; negative brows frown. `aside`: side of the tongue, -1 Mri's -x
/// .. 1 +x. `blink`: 1: the upper lids are down.
struct Expression {
  double smile = 0.0, tongue = 0.0, lips_in = 0.0, cheeks = 0.0, brows = 0.0, aside = 0.0, blink = 0.0;

  bool isNone() const { return *this == Expression{}; }
  bool operator==(const Expression& other) const {
    return smile == other.smile && tongue == other.tongue && lips_in == other.lips_in &&
           cheeks == other.cheeks && brows == other.brows && aside == other.aside && blink == other.blink;
  }
};

/// Distance by which the chin is lowered when the tongue is out, mm.
double jawOf_mm(const Expression& expression);

/// Shift (Mri, mm) of a skin point with its outward unit normal, without the lowered jaw. `landmarks_mm`:
/// iBUG 68 in Mri. Up to 10 mm at the mouth, 1-3 mm at brows and forehead.
Eigen::Vector3d expressionShift_mm(const Expression& expression, const Eigen::Vector3d& p_mm,
                                   const Eigen::Vector3d& normal,
                                   const std::vector<Eigen::Vector3d>& landmarks_mm);

/// The visible part between the lips (tongue, teeth or closed lips), at a point of the skin at rest.
SkinPaint mouthPaint(const Expression& expression, const Eigen::Vector3d& p_mm,
                     const std::vector<Eigen::Vector3d>& landmarks_mm);

}  // namespace facenav::room
