#pragma once
// ScaleObservation: a length that is known (the coil's marker), as both cameras measure it. A camera that
// turned sideways since the calibration measures every length too long or too short, as it measures every
// distance. Camera, mm.

#include "facenav/geometry/point.h"

namespace facenav::health {

struct ScaleObservation {
  Point<Camera> at;    // where the length was measured
  double ratio = 1.0;  // measured length over the true one
  double sigma = 0.0;  // standard error of the ratio
};

}  // namespace facenav::health
