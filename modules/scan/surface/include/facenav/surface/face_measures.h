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
  double uncertainty_mm = 0;        // 95 of 100 repetitions lie within
  std::optional<UsualRange> usual;  // adults; nothing where no range is known
  bool is_lower_bound = false;      // an end lies on the scan's edge: the true value may be larger

  /// Within the adult range, allowing for the uncertainty. A lower bound can only be too large.
  bool isUsual() const;
};

/// The measures whose landmarks were found. `voxel_mm`: the scan's largest voxel edge.
std::vector<FaceMeasure> measureFace(const FaceLandmarks& landmarks, double voxel_mm);

}  // namespace facenav::surface
