#include <cmath>

#include "facenav/registration/aligner.h"

namespace facenav::registration {

double AlignmentResult::predictedError_mm(const Point<Mri>& target) const {
  const Eigen::Vector3d lever = camera_T_mri.rotation() * target.mm;
  Eigen::Matrix<double, 3, 6> carry;
  carry << -skew(lever), Eigen::Matrix3d::Identity();
  return std::sqrt((carry * covariance * carry.transpose()).trace());
}

}  // namespace facenav::registration
