#pragma once
// HeadMotion: sway and nod of a seated head: a few slow sines per degree of freedom, seeded, starting at
// rest.

#include <Eigen/Geometry>
#include <array>
#include <cstdint>

namespace facenav::room {

struct MotionSize {
  Eigen::Vector3d rotation_deg{2.0, 3.0, 1.5};  // peak about Room x (nod), y (turn), z (tilt)
  Eigen::Vector3d shift_mm{6.0, 4.0, 8.0};      // peak along Room x, y, z
  double rate_hz = 0.35;                        // of the strongest component
};

class HeadMotion {
 public:
  HeadMotion(const MotionSize& size, std::uint64_t seed);
  /// Rotation vector (deg) and shift (mm) at a time; zero at 0 s.
  Eigen::Matrix<double, 6, 1> at(double time_s) const;

 private:
  struct Wave {
    double weight, rate_hz, phase;
  };
  std::array<std::array<Wave, 3>, 6> waves_;
  Eigen::Matrix<double, 6, 1> peak_;
};

}  // namespace facenav::room
