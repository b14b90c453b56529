#include "evaluate/gate_truth.h"

#include "facenav/geometry/rigid_fit.h"

namespace facenav::app {
namespace {

constexpr double kReach_mm = 70.0;

bool isIn(const cameras::StereoRig& rig, const Eigen::Vector2d& px) {
  return px.x() > 0 && px.y() > 0 && px.x() < rig.width_px - 1 && px.y() < rig.height_px - 1;
}

/// Points of the head (Mri), and where exact matches place them (Camera).
struct MeasuredPoints {
  std::vector<Eigen::Vector3d> of_head, measured;
  bool isEnough() const { return of_head.size() >= 8; }
};

MeasuredPoints measure(const cameras::StereoRig& truth, const cameras::StereoRig& used,
                       const Eigen::Isometry3d& camera_T_mri, const Eigen::Vector3d& middle_mm) {
  MeasuredPoints points;
  for (const double x : {-1.0, 0.0, 1.0})
    for (const double y : {-1.0, 0.0, 1.0})
      for (const double z : {-1.0, 0.0, 1.0}) {
        const Eigen::Vector3d p_mm = middle_mm + kReach_mm * Eigen::Vector3d(x, y, z);
        const Eigen::Vector3d there_mm = camera_T_mri * p_mm;
        const Eigen::Vector2d left = cameras::project(truth.left, there_mm),
                              right = cameras::project(truth.right, truth.right_T_left.isometry() * there_mm);
        if (!isIn(truth, left) || !isIn(truth, right)) continue;
        points.of_head.push_back(p_mm);
        points.measured.push_back(cameras::triangulate(used, left, right).mm);
      }
  return points;
}

}  // namespace

Eigen::Isometry3d poseAsMeasured(const cameras::StereoRig& truth, const cameras::StereoRig& used,
                                 const Eigen::Isometry3d& camera_T_mri, const Eigen::Vector3d& middle_mm) {
  const auto points = measure(truth, used, camera_T_mri, middle_mm);
  return points.isEnough() ? fitRigidPoints(points.of_head, points.measured).to_T_from : camera_T_mri;
}

double sizeAsMeasured(const cameras::StereoRig& truth, const cameras::StereoRig& used,
                      const Eigen::Isometry3d& camera_T_mri, const Eigen::Vector3d& middle_mm) {
  const auto points = measure(truth, used, camera_T_mri, middle_mm);
  double true_mm = 0.0, measured_mm = 0.0;
  for (std::size_t i = 0; i < points.of_head.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      true_mm += (points.of_head[i] - points.of_head[j]).norm();
      measured_mm += (points.measured[i] - points.measured[j]).norm();
    }
  return true_mm > 0.0 ? measured_mm / true_mm : 1.0;
}

}  // namespace facenav::app
