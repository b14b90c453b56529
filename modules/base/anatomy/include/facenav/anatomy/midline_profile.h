#pragma once
// The head's outline in its plane of symmetry, and the landmarks that anthropometry defines on it (Farkas,
// Anthropometry of the Head and Face, 1994). They depend only on curvature and distances along the line, so
// that a nodding head has the same landmarks.

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace facenav::anatomy {

/// Points (front, up), mm, from the vertex down over the face (or over the back of the head), about 0.7 mm
/// apart, to the end of the scan.
using Outline = std::vector<Eigen::Vector2d>;

struct MidlineProfile {
  Outline front, back;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  // inside the cranium
};
/// Profile of a head. `head_mm`: vertices of the skin in the head frame, where the plane of symmetry is x =
/// 0; `triangles`: their indices.
MidlineProfile midlineProfile(const std::vector<Eigen::Vector3d>& head_mm,
                              const std::vector<Eigen::Vector3i>& triangles);

struct MidlineLandmarks {
  std::optional<Eigen::Vector2d> glabella, nasion, pronasale, subnasale, pogonion, opisthocranion;
  /// Place where the back of the head bends into the neck. On many heads no bump of the bone shows on the
  /// skin (Myslobodsky and Bar-Ziv 1989: hard to define in over 30 %), so this is the bend, not the bump.
  std::optional<Eigen::Vector2d> inion;
};
/// Finds the landmarks. The result is empty if the outline has no nose, ends above a landmark, or the head is
/// tilted back by more than 50 degrees.
MidlineLandmarks midlineLandmarks(const MidlineProfile& profile);

}  // namespace facenav::anatomy
