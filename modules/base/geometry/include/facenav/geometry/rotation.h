#pragma once
// Rotation vectors and rigid increments: the parametrisation used by every pose optimiser in FaceNav.

#include <Eigen/Geometry>

namespace facenav {
inline namespace geometry {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

inline constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;
inline constexpr double kDegPerRad = 180.0 / 3.14159265358979323846;

/// Rotation by |w| rad about w (exponential map).
Eigen::Matrix3d expRotation(const Eigen::Vector3d& rotation_vector_rad);
/// The rotation vector of R, length in 0..pi rad.
Eigen::Vector3d logRotation(const Eigen::Matrix3d& rotation);
/// Angle of R in rad, 0..pi; also accurate near 0.
double rotationAngle(const Eigen::Matrix3d& rotation);
/// Left increment: p -> exp(w) p + v for xi = (w rad, v mm).
Eigen::Isometry3d expRigid(const Vector6d& xi);
Eigen::Matrix3d skew(const Eigen::Vector3d& v);

}  // namespace geometry
}  // namespace facenav
