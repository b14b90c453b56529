#pragma once
// Tests whether the scan has a face for alignment: it looks for a face's relief on the skin, in the head's
// own axes, and compares the face's sharpness with the same head's other skin. A face may be removed or
// blurred (a defaced scan), or cut by the scan's edge.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "facenav/anatomy/face_match.h"
#include "facenav/geometry/point.h"
#include "scalp/scalp_outline.h"

namespace facenav::surface {

enum class FaceState {
  whole,       // as far as the scan shows it
  unclear,     // hard to make out, or less sharp than the other skin: a caution
  blurred,     // by a program, or smoothed
  removed,     // no place is like a face where the scan shows the front of the head
  cut_off,     // the scan's edge cuts the front of the face off
  not_in_scan  // the scan ends above the nose
};

/// What was measured. Ratios compare the face with the same head's other skin.
struct FaceEvidence {
  std::optional<anatomy::FaceMatch> match;
  std::optional<double> detail;      // fine relief of the face over that of the forehead
  std::optional<double> edge_width;  // width of the skin's edge in the face over that of the upper head
  double height_mm = 0;              // from the top of the head to the lowest skin of its front
  double cut_mm = 0;                 // extent of the hole that the scan's front edge cuts, the smaller of two
  double cut_ahead_mm = 0;           // how far in front of the forehead that hole lies
};
FaceState judgeFace(const FaceEvidence& evidence);

struct FaceCheck {
  bool has_face = false;
  bool has_cut_ear = false;           // true: the last of `findings` describes it
  std::vector<std::string> findings;  // plain words, most important first
  FaceState state = FaceState::removed;
  FaceEvidence evidence;
};

/// Planes that bound the scan: a point on each, and its normal out of the scan.
using ScanEnds = std::vector<std::pair<Point<Mri>, Direction<Mri>>>;

/// Checks the face. `edge_width_mm`: per vertex of `scalp` (edge_width.h).
FaceCheck checkFace(const TriangleMesh& scalp, const MeshNeighbours& neighbours, const ScanEnds& ends,
                    const std::vector<float>& edge_width_mm);

}  // namespace facenav::surface
