#pragma once
// The four errors of a pulse as Brainsight defines them. Checked on 1,375 samples of real exports; they
// differ from guidance.csv: the twist is measured in the plane across the sample's axis.

#include "facenav/geometry/rigid_transform.h"

namespace facenav::interop {

struct BrainsightErrors {
  double distance_mm = 0;  // "Dist. to Target"
  double target_mm = 0;    // "Target Error": of the target from the sample's axis
  double angular_deg = 0;  // "Angular Error": between the axes
  double twist_deg = 0;    // "Twist Error", signed about Brainsight's z (out of the head)
};

BrainsightErrors brainsightErrors(const RigidTransform<Mri, Coil>& sample,
                                  const RigidTransform<Mri, Coil>& target);

}  // namespace facenav::interop
