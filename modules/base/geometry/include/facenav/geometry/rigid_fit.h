#pragma once
// Closed-form rigid fit of corresponding points with weights (equation 2 of the 2010 paper), solved as in
// Arun, Huang, Blostein 1987 / Umeyama 1991 (det +1 enforced).

#include <vector>

#include "facenav/geometry/rigid_transform.h"

namespace facenav {
inline namespace geometry {

struct RigidFit {
  Eigen::Isometry3d to_T_from;
  double rms_mm;  // weighted root mean square residual
};

/// Minimises sum w_i |R from_i + t - to_i|^2. Both lists have the same size; weights are empty (all 1) or one
/// per pair, >= 0. Throws Error if fewer than 3 pairs have weight or the pairs lie on one line.
RigidFit fitRigidPoints(const std::vector<Eigen::Vector3d>& from_mm,
                        const std::vector<Eigen::Vector3d>& to_mm, const std::vector<double>& weights = {});

template <class To, class From>
RigidTransform<To, From> fitRigid(const PointCloud<From>& from, const PointCloud<To>& to,
                                  const std::vector<double>& weights = {}) {
  return RigidTransform<To, From>::fromIsometry(
      fitRigidPoints(from.points_mm, to.points_mm, weights).to_T_from);
}

}  // namespace geometry
}  // namespace facenav
