#pragma once
// The head's outline in its plane of symmetry, and the landmarks that anthropometry defines on it (Farkas,
// Anthropometry of the Head and Face, 1994): all from curvature and distances along the line, so that a
// nodding head gives the same ones.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "facenav/surface/triangle_mesh.h"

namespace facenav::surface {

/// Points (front, up), mm, from the vertex down over the face (or over the back of the head), about 0.7 mm
/// apart. Ends where the scan does.
using Outline = std::vector<Eigen::Vector2d>;

struct MidlineProfile {
  Outline front, back;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  // inside the cranium
};
/// `head_mm`: vertices in the head frame, where the plane of symmetry is x = 0.
MidlineProfile midlineProfile(const std::vector<Eigen::Vector3d>& head_mm, const TriangleMesh& mesh);

struct MidlineLandmarks {
  std::optional<Eigen::Vector2d> glabella, nasion, pronasale, subnasale, pogonion, opisthocranion;
};
/// Empty where the outline has no nose, or ends before a landmark.
MidlineLandmarks midlineLandmarks(const MidlineProfile& profile);

}  // namespace facenav::surface
