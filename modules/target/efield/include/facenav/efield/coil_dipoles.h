#pragma once
// CoilDipoles: a coil as magnetic dipoles, the form in which every field of this module takes it. Made by the
// built-in coils (built_in_coils.h), the readers of coil files (coil_file.h) and thinnedCoil
// (thinned_coil.h).

#include <Eigen/Core>
#include <string>

namespace facenav::efield {

/// Magnetic dipoles that stand for a coil's winding, in the Coil frame (+z into the head, +y away from the
/// handle).
struct CoilDipoles {
  Eigen::Matrix3Xd positions_mm;     ///< 3 x n, frame Coil
  Eigen::Matrix3Xd moments_Am2;      ///< 3 x n, A m^2 per ampere of coil current, frame Coil
  double largest_didt_A_per_us = 0;  ///< rate of the current at 100 % output; 0 = not known
  std::string name;                  ///< as the file or the built-in coil says
};

}  // namespace facenav::efield
