#pragma once
// Electric field of a coil in closed form: of the coil alone, and in a sphere. Fields are in V/m for a rate
// of the current of 1 A/us; E = -(dI/dt) (mu0 / 4 pi) ..., so a positive current as in the coil's file drives
// them. Points and fields are in Mri. Source of the sphere: Heller and van Hulsteyn, Biophys J 63 (1992) 129,
// which follows from Sarvas, Phys Med Biol 32 (1987) 11, by reciprocity.

#include "facenav/efield/coil_dipoles.h"
#include "facenav/geometry/rigid_transform.h"

namespace facenav::efield {

/// Electric field of the coil alone (V/m, 3 x n), Mri frame, at points_mm (3 x n, Mri), for dI/dt = 1 A/us.
Eigen::Matrix3Xd primaryField(const CoilDipoles& coil, const RigidTransform<Mri, frames::Coil>& mri_T_coil,
                              const Eigen::Matrix3Xd& points_mm);

/// The same with the secondary field of a sphere about `centre_mm`. It does not depend on the sphere's radius
/// nor on its conductivity, as long as that depends on the radius alone. The coil lies outside the sphere.
Eigen::Matrix3Xd sphereField(const CoilDipoles& coil, const RigidTransform<Mri, frames::Coil>& mri_T_coil,
                             const Eigen::Vector3d& centre_mm, const Eigen::Matrix3Xd& points_mm);

}  // namespace facenav::efield
