#pragma once
// Dice: seeded random numbers, the same on every machine.

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <random>

namespace facenav::room {

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}
  double between(double low, double high) { return low + (high - low) * double(random_() >> 11) * 0x1p-53; }
  /// Draws a unit vector, uniform over the sphere.
  Eigen::Vector3d direction() {
    const double z = between(-1.0, 1.0), about = between(0.0, 2.0 * M_PI), r = std::sqrt(1.0 - z * z);
    return {r * std::cos(about), r * std::sin(about), z};
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace facenav::room
