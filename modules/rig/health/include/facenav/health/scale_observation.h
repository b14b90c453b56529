#pragma once
// ScaleObservation: a known length (the coil's marker) as measured by both cameras. If a camera turned
// sideways since the calibration, every length and distance is measured too long or too short by the same
// ratio. Camera, mm.

#include "facenav/geometry/point.h"

namespace facenav::health {

struct ScaleObservation {
  Point<Camera> at;    // place of the measured length
  double ratio = 1.0;  // measured length over the true one
  double sigma = 0.0;  // standard error of the ratio
};

}  // namespace facenav::health
