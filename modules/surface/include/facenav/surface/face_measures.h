#pragma once
// The sheet of face measures to hold against the person in the chair: is this scan of this patient, and is
// its scale right? Each with its uncertainty and the adult range; ranges and their sources:
// facenav/anatomy/face_norms.h.

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
  double uncertainty_mm = 0;        // 95 of 100 repetitions stay within
  std::optional<UsualRange> usual;  // adults; nothing where no range is known
  bool is_lower_bound = false;      // an end lies on the scan's edge: the true value may be larger

  /// Within the adult range, the uncertainty allowed for; a lower bound is only ever too large.
  bool isUsual() const;
};

/// Those measures whose landmarks were found. `voxel_mm`: the scan's largest voxel edge.
std::vector<FaceMeasure> measureFace(const FaceLandmarks& landmarks, double voxel_mm);

}  // namespace facenav::surface
