#pragma once
// smoothStep: 0 below 0, 1 above 1, with zero slope at both ends.

#include <algorithm>

namespace facenav::room {

inline double smoothStep(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

}  // namespace facenav::room
