#include "facenav/efield/primary_field.h"

#include <cmath>

#include "facenav/core/parallel_for.h"

namespace facenav::efield {
namespace {

constexpr double kRate = 1e6 * 1e-7;  // dI/dt of 1 A/us in A/s, times mu0 / 4 pi
constexpr double kMetresPerMm = 1e-3;

/// Dipoles in metres, relative to an origin in Mri, axes of Mri.
struct PlacedDipoles {
  Eigen::Matrix3Xd positions_m, moments_Am2;
};

PlacedDipoles placed(const CoilDipoles& coil, const RigidTransform<Mri, frames::Coil>& mri_T_coil,
                     const Eigen::Vector3d& origin_mm) {
  const Eigen::Vector3d shift_mm = mri_T_coil.translation_mm() - origin_mm;
  PlacedDipoles result;
  result.positions_m = kMetresPerMm * ((mri_T_coil.rotation() * coil.positions_mm).colwise() + shift_mm);
  result.moments_Am2 = mri_T_coil.rotation() * coil.moments_Am2;
  return result;
}

Eigen::Vector3d primaryAt(const PlacedDipoles& dipoles, const Eigen::Vector3d& r) {
  Eigen::Vector3d field = Eigen::Vector3d::Zero();
  for (Eigen::Index k = 0; k < dipoles.positions_m.cols(); ++k) {
    const Eigen::Vector3d d = r - dipoles.positions_m.col(k), m = dipoles.moments_Am2.col(k);
    const double distance2 = d.squaredNorm();
    field += m.cross(d) / (distance2 * std::sqrt(distance2));
  }
  return -kRate * field;
}

/// Field at r in a sphere about the origin.
Eigen::Vector3d inSphereAt(const PlacedDipoles& dipoles, const Eigen::Vector3d& r) {
  Eigen::Vector3d field = Eigen::Vector3d::Zero();
  for (Eigen::Index k = 0; k < dipoles.positions_m.cols(); ++k) {
    const Eigen::Vector3d q = dipoles.positions_m.col(k), m = dipoles.moments_Am2.col(k), a = q - r;
    const double a_norm = a.norm(), q_norm = q.norm(), qa = q.dot(a);
    const double f = a_norm * (q_norm * a_norm + qa);
    const double along_q = a_norm * a_norm / q_norm + 2 * a_norm + 2 * q_norm + qa / a_norm;
    const double along_r = a_norm + 2 * q_norm + qa / a_norm;
    const double m_g = along_q * m.dot(q) - along_r * m.dot(r);
    field += (f * r.cross(m) - m_g * r.cross(q)) / (f * f);
  }
  return -kRate * field;
}

template <class FieldAt>
Eigen::Matrix3Xd fieldAtAll(const Eigen::Matrix3Xd& points_mm, const Eigen::Vector3d& origin_mm,
                            const FieldAt& at) {
  Eigen::Matrix3Xd field(3, points_mm.cols());
  parallelRanges(0, int(points_mm.cols()), [&](int begin, int end) {
    for (int i = begin; i < end; ++i) field.col(i) = at(kMetresPerMm * (points_mm.col(i) - origin_mm));
  });
  return field;
}

}  // namespace

Eigen::Matrix3Xd primaryField(const CoilDipoles& coil, const RigidTransform<Mri, frames::Coil>& mri_T_coil,
                              const Eigen::Matrix3Xd& points_mm) {
  const Eigen::Vector3d origin_mm = Eigen::Vector3d::Zero();
  const auto dipoles = placed(coil, mri_T_coil, origin_mm);
  return fieldAtAll(points_mm, origin_mm, [&](const Eigen::Vector3d& r) { return primaryAt(dipoles, r); });
}

Eigen::Matrix3Xd sphereField(const CoilDipoles& coil, const RigidTransform<Mri, frames::Coil>& mri_T_coil,
                             const Eigen::Vector3d& centre_mm, const Eigen::Matrix3Xd& points_mm) {
  const auto dipoles = placed(coil, mri_T_coil, centre_mm);
  return fieldAtAll(points_mm, centre_mm, [&](const Eigen::Vector3d& r) { return inSphereAt(dipoles, r); });
}

}  // namespace facenav::efield
