#include "start_poses.h"

#include <algorithm>
#include <cmath>

#include "facenav/geometry/rotation.h"

namespace facenav::registration {
namespace {

Eigen::Matrix3d turned(const Eigen::Matrix3d& base, double yaw_deg, double pitch_deg, double roll_deg = 0) {
  return base * (Eigen::AngleAxisd(yaw_deg * kRadPerDeg, Eigen::Vector3d::UnitZ()) *
                 Eigen::AngleAxisd(pitch_deg * kRadPerDeg, Eigen::Vector3d::UnitX()) *
                 Eigen::AngleAxisd(roll_deg * kRadPerDeg, Eigen::Vector3d::UnitY()))
                    .toRotationMatrix();
}

/// Columns: the patient's right, anterior and superior in Camera.
Eigen::Matrix3d orientationFrom(const Eigen::Vector3d& right, const Eigen::Vector3d& up) {
  Eigen::Matrix3d r;
  r.col(2) = up.normalized();
  r.col(0) = (right - right.dot(r.col(2)) * r.col(2)).normalized();
  r.col(1) = r.col(2).cross(r.col(0));
  return r;
}

}  // namespace

std::optional<Eigen::Matrix3d> hintedOrientation(const AlignmentStart& start) {
  const Eigen::Vector3d towards_camera(0, 0, -1);
  if (start.patient_right && start.patient_superior) {
    if (std::abs(start.patient_right->v.dot(start.patient_superior->v)) > 0.9) return {};
    return orientationFrom(start.patient_right->v, start.patient_superior->v);
  }
  // anterior = superior x right
  if (start.patient_superior && std::abs(start.patient_superior->v.z()) < 0.9)
    return orientationFrom(towards_camera.cross(start.patient_superior->v), start.patient_superior->v);
  if (start.patient_right && std::abs(start.patient_right->v.z()) < 0.9)
    return orientationFrom(start.patient_right->v, start.patient_right->v.cross(towards_camera));
  return {};
}

std::vector<Eigen::Matrix3d> facingOrientations(bool is_fine) {
  Eigen::Matrix3d upright;
  upright << -1, 0, 0, 0, 0, -1, 0, -1, 0;
  const std::vector<double> yaws =
      is_fine ? std::vector<double>{-50, -25, 0, 25, 50} : std::vector<double>{-45, -15, 15, 45};
  const std::vector<double> pitches =
      is_fine ? std::vector<double>{-40, -20, 0, 20, 40} : std::vector<double>{-25, 5, 30};
  std::vector<Eigen::Matrix3d> out;
  for (int roll = 0; roll < 360; roll += is_fine ? 20 : 30)
    for (const double yaw : yaws)
      for (const double pitch : pitches)
        out.push_back(
            turned(Eigen::AngleAxisd(roll * kRadPerDeg, Eigen::Vector3d::UnitZ()) * upright, yaw, pitch));
  return out;
}

std::vector<Eigen::Matrix3d> orientationsAround(const Eigen::Matrix3d& base, double reach_deg) {
  std::vector<Eigen::Matrix3d> out{base};
  for (const double yaw : {-1.0, 0.0, 1.0})
    for (const double pitch : {-1.0, 0.0, 1.0})
      for (const double roll : {-1.0, 0.0, 1.0})
        if (yaw != 0 || pitch != 0 || roll != 0)
          out.push_back(turned(base, yaw * reach_deg, pitch * reach_deg, roll * reach_deg));
  return out;
}

Eigen::Vector3d foremostSkin(const ScalpField& scalp, const Eigen::Vector3d& towards_camera) {
  // Mean of the most advanced hundredth, since a single vertex could be an outlier.
  const auto& vertices = scalp.skin().points.points_mm;
  std::vector<std::pair<double, int>> advance;
  const std::size_t stride = std::max<std::size_t>(1, vertices.size() / 3000);
  for (std::size_t v = 0; v < vertices.size(); v += stride)
    advance.emplace_back(-vertices[v].dot(towards_camera), int(v));
  const std::size_t most = std::max<std::size_t>(1, advance.size() / 100);
  std::nth_element(advance.begin(), advance.begin() + std::ptrdiff_t(most), advance.end());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t a = 0; a < most; ++a) sum += vertices[std::size_t(advance[a].second)];
  return sum / double(most);
}

Eigen::Isometry3d placed(const Eigen::Matrix3d& camera_R_mri, const Eigen::Vector3d& p_mri,
                         const Eigen::Vector3d& p_camera) {
  Eigen::Isometry3d camera_T_mri = Eigen::Isometry3d::Identity();
  camera_T_mri.linear() = camera_R_mri;
  camera_T_mri.translation() = p_camera - camera_R_mri * p_mri;
  return camera_T_mri.inverse();
}

bool seesTheFace(const Eigen::Isometry3d& mri_T_camera, const Eigen::Vector3d& middle_mri_mm) {
  constexpr double kLeastAnterior = 0.17;  // cosine; up to 80 degrees from straight ahead
  return (mri_T_camera.translation() - middle_mri_mm).normalized().y() > kLeastAnterior;
}

}  // namespace facenav::registration
