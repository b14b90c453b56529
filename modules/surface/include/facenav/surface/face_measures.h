#pragma once
// The sheet of face measures to hold against the person in the chair: is this scan of this patient, and is
// its scale right? Each with its uncertainty and the adult range (means of both sexes with two standard
// deviations, from Farkas 1994 and ANSUR II 2012, rounded outwards; children and other populations differ).

#include <string>
#include <vector>

#include "facenav/surface/face_landmarks.h"

namespace facenav::surface {

struct FaceMeasure {
  std::string name, from, to;  // plain words, then the two landmarks
  double value_mm = 0;
  double uncertainty_mm = 0;                   // 95 of 100 repetitions stay within
  double usual_low_mm = 0, usual_high_mm = 0;  // adults; both 0 where no range is known
  bool is_lower_bound = false;                 // an end lies on the scan's edge: the true value may be larger

  /// Within the adult range, the uncertainty allowed for; a lower bound is only ever too large.
  bool isUsual() const;
};

/// Those measures whose landmarks were found. `voxel_mm`: the scan's largest voxel edge.
std::vector<FaceMeasure> measureFace(const FaceLandmarks& landmarks, double voxel_mm);

}  // namespace facenav::surface
