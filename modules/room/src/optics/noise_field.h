#pragma once
// NoiseField: smooth random values in space, zero mean, unit deviation, periodic; the grain of skin, hair and
// walls. Depends on its seed alone.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace facenav::room {

class NoiseField {
 public:
  explicit NoiseField(std::uint64_t seed);
  /// Value at p_mm; structure sizes are about two times `grain_mm`.
  float at(const Eigen::Vector3d& p_mm, double grain_mm) const;

 private:
  std::vector<float> cells_;
};

/// The field that all looks share.
const NoiseField& sharedNoise();

}  // namespace facenav::room
