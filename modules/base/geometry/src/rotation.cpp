#include "facenav/geometry/rotation.h"

#include <cmath>

#include "facenav/core/error.h"
#include "facenav/geometry/rigid_transform.h"

namespace facenav {
inline namespace geometry {

Eigen::Matrix3d skew(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

Eigen::Matrix3d expRotation(const Eigen::Vector3d& w_rad) {
  const double angle = w_rad.norm();
  if (angle < 1e-12)
    return Eigen::Quaterniond(1, w_rad.x() / 2, w_rad.y() / 2, w_rad.z() / 2).normalized().matrix();
  return Eigen::AngleAxisd(angle, w_rad / angle).toRotationMatrix();
}

Eigen::Vector3d logRotation(const Eigen::Matrix3d& rotation) {
  Eigen::Quaterniond q(rotation);
  if (q.w() < 0) q.coeffs() *= -1;
  const double sine = q.vec().norm();
  if (sine < 1e-12) return 2.0 * q.vec();
  return q.vec() * (2.0 * std::atan2(sine, q.w()) / sine);
}

double rotationAngle(const Eigen::Matrix3d& rotation) { return logRotation(rotation).norm(); }

Eigen::Isometry3d expRigid(const Vector6d& xi) {
  Eigen::Isometry3d increment = Eigen::Isometry3d::Identity();
  increment.linear() = expRotation(xi.head<3>());
  increment.translation() = xi.tail<3>();
  return increment;
}

void requireRigid(const Eigen::Matrix4d& matrix, double tolerance) {
  const Eigen::Matrix3d r = matrix.topLeftCorner<3, 3>();
  if (!matrix.allFinite()) throw Error("transform holds a number that is not finite");
  if ((r * r.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() > tolerance)
    throw Error("transform is not rigid (its axes are not orthonormal)");
  if (r.determinant() < 0) throw Error("transform is mirrored (determinant -1), a left-right flip");
  if ((matrix.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).cwiseAbs().maxCoeff() > tolerance)
    throw Error("transform's last row is not 0 0 0 1");
}

}  // namespace geometry
}  // namespace facenav
