#pragma once
// Eyelid: the change of the face in a blink. The upper lid slides down over the eye and pulls the skin around
// the eye along. Lid skin with a row of lashes at its rim replaces the picture of the eye.

#include <Eigen/Core>
#include <vector>

#include "skin_paint.h"

namespace facenav::room {

/// Shift (Mri, mm) of a skin point with its outward unit normal. `closed`: 0 open .. 1 the upper lid is down.
/// Zero more than 18 mm from both eyes. `landmarks_mm`: iBUG 68 in Mri.
Eigen::Vector3d lidShift_mm(double closed, const Eigen::Vector3d& p_mm, const Eigen::Vector3d& normal,
                            const std::vector<Eigen::Vector3d>& landmarks_mm);

/// Paint of lid skin and lashes over the eye, at a point of the skin at rest.
SkinPaint lidPaint(double closed, const Eigen::Vector3d& p_mm,
                   const std::vector<Eigen::Vector3d>& landmarks_mm);

}  // namespace facenav::room
