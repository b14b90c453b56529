#pragma once
// NoiseField: smooth random values in space, zero mean, unit deviation, periodic. Used for the grain of skin,
// hair and walls. The same seed gives the same field.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace facenav::room {

class NoiseField {
 public:
  explicit NoiseField(std::uint64_t seed);
  /// Value at p_mm; structures are about twice `grain_mm` in size.
  float at(const Eigen::Vector3d& p_mm, double grain_mm) const;

 private:
  std::vector<float> cells_;
};

/// The field shared by all looks.
const NoiseField& sharedNoise();

}  // namespace facenav::room
