#pragma once
// The list of face measures to compare with the patient: is this scan of this patient, and is its scale
// right? Each has its uncertainty and the adult range. Ranges and sources: facenav/anatomy/face_norms.h.

#include <optional>
#include <string>
#include <vector>

#include "facenav/surface/face_landmarks.h"

namespace facenav::surface {

struct UsualRange {
  double low_mm = 0, high_mm = 0;
};

struct FaceMeasure {
  std::string name, from, to;  // plain words, then the two landmarks
  double value_mm = 0;
  double uncertainty_mm = 0;        // half width of the interval that contains 95 of 100 repetitions
  std::optional<UsualRange> usual;  // adult range; nullopt if none is known
  bool is_lower_bound = false;      // an end lies on the scan's edge: the true value may be larger

  /// True within the adult range, allowing for the uncertainty. A lower bound can only be too large.
  bool isUsual() const;
};

/// Measures whose landmarks were found. `voxel_mm`: the scan's largest voxel edge.
std::vector<FaceMeasure> measureFace(const FaceLandmarks& landmarks, double voxel_mm);

}  // namespace facenav::surface
