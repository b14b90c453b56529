#pragma once
// Thins a coil of many dipoles to few, so that a field costs little: the dipoles are grouped, and the moments
// at the groups' middles are fitted to the flux on a plane 10 mm below the casing. The error is measured, not
// assumed.

#include "facenav/efield/coil_dipoles.h"

namespace facenav::efield {

struct ThinnedCoil {
  CoilDipoles coil;
  /// Largest relative error of the field against the given dipoles, on shells 12 to 40 mm deep in a sphere of
  /// 92 mm that touches the contact face. 0 where nothing was thinned.
  double relative_error = 0;
};

constexpr int kMostDipoles = 100;
/// Largest error of a thinned coil that replaces the given dipoles.
constexpr double kLargestThinningError = 0.005;

/// Returns at most `most` dipoles. The given ones are returned where they are that few, where the coil bends
/// round the head (dipoles beyond the contact face), or where the error would exceed kLargestThinningError.
ThinnedCoil thinnedCoil(const CoilDipoles& coil, int most = kMostDipoles);

/// Relative error of a coil's field against another's, as in ThinnedCoil.
double relativeErrorInSphere(const CoilDipoles& coil, const CoilDipoles& reference);

}  // namespace facenav::efield
