#pragma once
// PersonShape: another size, other proportions and other soft tissue of a head. The same shape applied to a
// scan's skin and to the person in the room gives one more person with that scan.

#include <Eigen/Core>
#include <cstdint>
#include <memory>

#include "facenav/room/virtual_patient.h"

namespace facenav::room {

struct PersonShape {
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();  // along Mri's axes, about `centre_mm`
  double soft_mm = 0.0;                             // standard deviation of the skin's smooth shift, per axis
  Eigen::Vector3d noise_mm =
      Eigen::Vector3d::Zero();  // place in the field of noise: another one, other tissue
  Eigen::Vector3d centre_mm = Eigen::Vector3d::Zero();

  /// Place of a point of the head (Mri, mm) in the changed head.
  Eigen::Vector3d operator()(const Eigen::Vector3d& p_mm) const;
};

/// Makes the head of that shape. `complexion_seed`: of blotches and freckles. `is_mirrored`: with the
/// portrait's sides exchanged.
VirtualPatient shapedLike(const VirtualPatient& patient, const PersonShape& shape,
                          std::uint64_t complexion_seed, bool is_mirrored);

/// Returns the person with a beard over cheeks, lips' surround and chin, up to `thickest_mm` above the skin.
/// Unchanged without landmarks. The skin itself, as an MRI shows it, stays.
VirtualPatient withBeard(const VirtualPatient& patient, double thickest_mm, std::uint64_t seed);

}  // namespace facenav::room
