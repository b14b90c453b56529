#include "kept_shells.h"

#include "facenav/efield/primary_field.h"

namespace facenav::steps {

Eigen::Matrix3Xd KeptShells::elsewhere(const Eigen::Matrix3Xf& shells, const efield::CoilDipoles& coil,
                                       const RigidTransform<Mri, frames::Coil>& mri_T_coil,
                                       const Eigen::Vector3d& centre_mm,
                                       const Eigen::Matrix3Xd& points_mm) const {
  std::vector<Eigen::Index> nearest(std::size_t(points_mm.cols()));
  Eigen::Matrix3Xd kept_mm(3, points_mm.cols());
  for (Eigen::Index i = 0; i < points_mm.cols(); ++i) {
    nearest[std::size_t(i)] = places.nearest(points_mm.col(i).cast<float>());
    kept_mm.col(i) = at_mm.col(nearest[std::size_t(i)]);
  }
  Eigen::Matrix3Xd result = efield::sphereField(coil, mri_T_coil, centre_mm, points_mm) -
                            efield::sphereField(coil, mri_T_coil, centre_mm, kept_mm);
  for (Eigen::Index i = 0; i < result.cols(); ++i)
    result.col(i) += shells.col(nearest[std::size_t(i)]).cast<double>();
  return result;
}

}  // namespace facenav::steps
