#pragma once
// Anthropometric landmarks on the scalp of an MRI (names and definitions: Farkas, Anthropometry of the Head
// and Face, 1994), in Mri mm. Each has the standard deviation of its placement. A landmark on the scan's edge
// is marked, because the true point may lie outside.

#include <optional>
#include <string>
#include <vector>

#include "facenav/surface/scalp_surface.h"

namespace facenav::surface {

struct FaceLandmark {
  std::string name;  // "nasion", "pronasale", "endocanthion R", ..; R and L are the patient's
  Point<Mri> point;
  double sd_mm = 1.0;   // standard deviation along a typical measure
  bool is_cut = false;  // on the scan's edge
};

struct FaceLandmarks {
  std::vector<FaceLandmark> points;
  std::optional<double> circumference_mm;  // over glabella and opisthocranion, as with a tape
  bool is_circumference_cut = false;
  Direction<Mri> right, front, up;  // the head's own axes

  /// Landmark of that name; nullopt if it was not found.
  std::optional<FaceLandmark> find(const std::string& name) const;
};

/// Finds the landmarks; empty if the scalp has no nose. Takes about a second.
FaceLandmarks findFaceLandmarks(const ScalpSurface& scalp);

}  // namespace facenav::surface
