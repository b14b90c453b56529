#pragma once
// The cumulative normal distribution.

#include <cmath>

namespace facenav::stimulation {

/// Share of a standard normal distribution below `z`.
inline double normalBelow(double z) { return 0.5 * std::erfc(-z * M_SQRT1_2); }

}  // namespace facenav::stimulation
