#pragma once
// RigidTransform<To, From> maps coordinates in From to coordinates in To, written to_T_from. `*` exists only
// if the inner frames match, so a wrong chain does not compile. The rotation is orthonormal with determinant
// +1: fromMatrix refuses a mirrored matrix (a left-right flip). Only reframe<A, B>() bypasses the frame
// types; search for it to find all such places.

#include <Eigen/Geometry>
#include <type_traits>

#include "facenav/core/error.h"
#include "facenav/geometry/point.h"

namespace facenav {
inline namespace geometry {

/// Throws Error unless `matrix` is a rigid motion within `tolerance` (orthonormal, det +1, last row 0 0 0 1).
void requireRigid(const Eigen::Matrix4d& matrix, double tolerance);

template <class To, class From>
class RigidTransform {
 public:
  /// The identity map (coordinates equal in both frames).
  RigidTransform() : isometry_(Eigen::Isometry3d::Identity()) {}
  RigidTransform(const Eigen::Quaterniond& rotation, const Eigen::Vector3d& translation_mm)
      : isometry_(Eigen::Isometry3d::Identity()) {
    isometry_.linear() = rotation.normalized().toRotationMatrix();
    isometry_.translation() = translation_mm;
  }
  /// Throws Error unless R is orthonormal with det +1. Files carry about 6 digits, hence the tolerance; the
  /// rotation is re-orthonormalised.
  static RigidTransform fromMatrix(const Eigen::Matrix4d& matrix, double tolerance = 1e-3) {
    requireRigid(matrix, tolerance);
    const Eigen::Quaterniond q(Eigen::Matrix3d(matrix.topLeftCorner<3, 3>()));
    return RigidTransform(q, matrix.topRightCorner<3, 1>());
  }
  static RigidTransform fromIsometry(const Eigen::Isometry3d& isometry) {
    RigidTransform transform;
    transform.isometry_ = isometry;
    return transform;
  }

  RigidTransform<From, To> inverse() const {
    return RigidTransform<From, To>::fromIsometry(isometry_.inverse());
  }
  template <class Other>
  RigidTransform<To, Other> operator*(const RigidTransform<From, Other>& right) const {
    return RigidTransform<To, Other>::fromIsometry(isometry_ * right.isometry());
  }
  Point<To> operator*(const Point<From>& point) const { return Point<To>(isometry_ * point.mm); }
  Direction<To> operator*(const Direction<From>& direction) const {
    return Direction<To>(isometry_.linear() * direction.v);
  }

  const Eigen::Isometry3d& isometry() const { return isometry_; }
  Eigen::Matrix4d matrix() const { return isometry_.matrix(); }
  Eigen::Matrix3d rotation() const { return isometry_.linear(); }
  Eigen::Vector3d translation_mm() const { return isometry_.translation(); }
  /// Unit quaternion with w >= 0, as in files.
  Eigen::Quaterniond quaternion() const {
    Eigen::Quaterniond q(Eigen::Matrix3d(isometry_.linear()));
    q.normalize();
    if (q.w() < 0) q.coeffs() *= -1;
    return q;
  }
  /// Declares that the same numbers are a transform between other frames. State the reason where you use it.
  template <class A, class B>
  RigidTransform<A, B> reframe() const {
    return RigidTransform<A, B>::fromIsometry(isometry_);
  }

 private:
  Eigen::Isometry3d isometry_;
};

template <class To, class From>
PointCloud<To> operator*(const RigidTransform<To, From>& to_T_from, const PointCloud<From>& cloud) {
  PointCloud<To> moved;
  moved.points_mm.reserve(cloud.size());
  for (const auto& p_mm : cloud.points_mm) moved.points_mm.push_back(to_T_from.isometry() * p_mm);
  moved.normals.reserve(cloud.normals.size());
  for (const auto& normal : cloud.normals) moved.normals.push_back(to_T_from.isometry().linear() * normal);
  return moved;
}

/// True if `A() * B()` compiles. Tests assert that it is false for frames that do not chain.
template <class A, class B, class = void>
struct composes : std::false_type {};
template <class A, class B>
struct composes<A, B, std::void_t<decltype(std::declval<A>() * std::declval<B>())>> : std::true_type {};

}  // namespace geometry
}  // namespace facenav
