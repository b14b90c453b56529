#pragma once
// The pose between two poses, for a moment between two frames.

#include "facenav/geometry/rigid_transform.h"

namespace facenav {
inline namespace geometry {

/// The pose at `fraction` of the way from `a` (0) to `b` (1): From's origin moves in a straight line, the
/// rotation has constant speed about one axis, by the shorter way (Shoemake 1985, slerp).
template <class To, class From>
RigidTransform<To, From> interpolated(const RigidTransform<To, From>& a, const RigidTransform<To, From>& b,
                                      double fraction) {
  return {a.quaternion().slerp(fraction, b.quaternion()),
          (1.0 - fraction) * a.translation_mm() + fraction * b.translation_mm()};
}

}  // namespace geometry
}  // namespace facenav
