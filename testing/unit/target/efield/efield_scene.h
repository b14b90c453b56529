#pragma once
// Three balls about the origin, a figure-8 coil of 42 dipoles, and the closed form of its field in a sphere
// (Heller and van Hulsteyn 1992), written here apart from the module.

#include <cmath>
#include <random>

#include "facenav/efield/field_solver.h"
#include "facenav/efield/head_model.h"

namespace facenav::efield::testing {

using Eigen::Vector3d;
using Pose = RigidTransform<Mri, frames::Coil>;

constexpr double kScalp_mm = 92, kOuterSkull_mm = 86, kInnerSkull_mm = 80;

inline ShellMesh ball(double radius_mm, int divisions, double upper_scale = 1.0) {
  ShellMesh mesh = icosphere(divisions, upper_scale);
  mesh.vertices_mm *= radius_mm;
  return mesh;
}
inline HeadModel balls(int divisions, double upper_scale = 1.0) {
  return {ball(kScalp_mm, divisions, upper_scale), ball(kOuterSkull_mm, divisions, upper_scale),
          ball(kInnerSkull_mm, divisions, upper_scale)};
}

/// Balls with the meshes that a case has: 2562 vertices on the inner skull, 1442 on the others, finer above.
inline HeadModel caseBalls() {
  ShellMesh coarser = geodesicSphere(outerParts(4), 0.75);
  HeadModel head{coarser, coarser, ball(kInnerSkull_mm, 4, 0.75)};
  head.scalp.vertices_mm *= kScalp_mm;
  head.outer_skull.vertices_mm *= kOuterSkull_mm;
  return head;
}

/// Figure-8 of 70 mm, moments matched (Thielscher and Kammer 2004 for the winding).
inline CoilDipoles figureEight() {
  CoilDipoles coil;
  coil.positions_mm.resize(3, 42);
  coil.moments_Am2.resize(3, 42);
  int dipole = 0;
  const auto add = [&](int side, double radius_mm, double turn, double moment) {
    coil.positions_mm.col(dipole) << side * 44 + radius_mm * std::cos(turn), radius_mm * std::sin(turn), -6.5;
    coil.moments_Am2.col(dipole++) << 0, 0, side * moment;
  };
  for (const int side : {-1, 1}) {
    add(side, 0, 0, 5.1167964e-3);
    for (int i = 0; i < 10; ++i) {
      add(side, 23.80544, 2 * M_PI * (i + 0.5) / 10, 2.2017721e-3);
      add(side, 37.734506, 2 * M_PI * i / 10, 8.3550493e-4);
    }
  }
  return coil;
}

inline CoilDipoles oneDipole(const Vector3d& position_mm, const Vector3d& moment) {
  return {position_mm, moment, 0, "one dipole"};
}

/// Field in a sphere about the origin, V/m at 1 A/us.
inline Eigen::Matrix3Xd closedForm(const CoilDipoles& coil, const Pose& mri_T_coil,
                                   const Eigen::Matrix3Xd& points_mm) {
  Eigen::Matrix3Xd field = Eigen::Matrix3Xd::Zero(3, points_mm.cols());
  for (Eigen::Index p = 0; p < points_mm.cols(); ++p)
    for (Eigen::Index d = 0; d < coil.positions_mm.cols(); ++d) {
      const Vector3d q = 1e-3 * (mri_T_coil.isometry() * Vector3d(coil.positions_mm.col(d)));
      const Vector3d m = mri_T_coil.rotation() * coil.moments_Am2.col(d), r = 1e-3 * points_mm.col(p),
                     a = q - r;
      const double la = a.norm(), lq = q.norm(), F = la * (lq * la + q.dot(a));
      const Vector3d G =
          (la * la / lq + 2 * la + 2 * lq + q.dot(a) / la) * q - (la + 2 * lq + q.dot(a) / la) * r;
      field.col(p) -= 1e6 * 1e-7 / (F * F) * (F * r.cross(m) - m.dot(G) * r.cross(q));
    }
  return field;
}

/// Magnetic field of a current dipole `current_Am` (A m) at `source_m` in a sphere about the origin, in tesla
/// at `place_m` outside it: Sarvas 1987, equation 25. SI units throughout.
inline Vector3d sarvasField(const Vector3d& source_m, const Vector3d& current_Am, const Vector3d& place_m) {
  const Vector3d a = place_m - source_m;
  const double la = a.norm(), lr = place_m.norm(), ar = a.dot(place_m);
  const double F = la * (lr * la + lr * lr - source_m.dot(place_m));
  const Vector3d gradient =
      (la * la / lr + ar / la + 2 * la + 2 * lr) * place_m - (la + 2 * lr + ar / la) * source_m;
  const Vector3d moment = current_Am.cross(source_m);
  return 1e-7 / (F * F) * (F * moment - moment.dot(place_m) * gradient);
}

class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}
  Vector3d direction() { return Vector3d(normal_(random_), normal_(random_), normal_(random_)).normalized(); }
  /// The coil flat on the upper half of the scalp, turned at random, `gap_mm` off.
  Pose pose(double gap_mm = 0) {
    Vector3d up = direction();
    up.z() = std::abs(up.z());
    const Vector3d x = up.cross(direction()).normalized();
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    matrix.topLeftCorner<3, 3>() << x, x.cross(up), -up;
    matrix.topRightCorner<3, 1>() = (kScalp_mm + gap_mm) * up;
    return Pose::fromMatrix(matrix);
  }
  /// Points at this radius, within 45 degrees of the coil.
  Eigen::Matrix3Xd pointsUnder(const Pose& pose, double radius_mm, int count) {
    Eigen::Matrix3Xd points(3, count);
    for (int p = 0; p < count;) {
      const Vector3d towards = direction();
      if (towards.dot(pose.rotation().col(2)) < -0.7) points.col(p++) = radius_mm * towards;
    }
    return points;
  }

 private:
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
};

template <class A, class B>
double relativeError(const A& found, const B& truth) {
  return (found - truth).norm() / truth.norm();
}

}  // namespace facenav::efield::testing
