#include "head_motion.h"

#include <cmath>
#include <random>

namespace facenav::room {

HeadMotion::HeadMotion(const MotionSize& size, std::uint64_t seed) {
  peak_ << size.rotation_deg, size.shift_mm;
  std::mt19937_64 random(seed);
  const auto uniform = [&random] { return double(random() >> 11) * 0x1p-53; };
  constexpr double kWeight[3] = {0.75, 0.2, 0.05}, kRate[3] = {1.0, 2.1, 4.7};
  for (auto& axis : waves_)
    for (int i = 0; i < 3; ++i)
      axis[i] = {kWeight[i], size.rate_hz * kRate[i] * (0.8 + 0.4 * uniform()), 2 * M_PI * uniform()};
}

Eigen::Matrix<double, 6, 1> HeadMotion::at(double time_s) const {
  Eigen::Matrix<double, 6, 1> value;
  const double start = 1.0 - std::exp(-std::pow(time_s / 0.25, 2));  // smooth start: no jump of speed at 0 s
  for (int axis = 0; axis < 6; ++axis) {
    double sum = 0.0;
    for (const Wave& wave : waves_[axis])
      sum += wave.weight * (std::sin(2 * M_PI * wave.rate_hz * time_s + wave.phase) - std::sin(wave.phase));
    value[axis] = start * peak_[axis] * sum;
  }
  return value;
}

}  // namespace facenav::room
