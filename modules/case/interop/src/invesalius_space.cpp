#include "facenav/interop/invesalius_space.h"

#include <cmath>

#include "facenav/geometry/rotation.h"
#include "facenav/interop/axes.h"
#include "facenav/interop/t1.h"

namespace facenav::interop {
namespace {

InvesaliusNumbers numbersOf(const Eigen::Vector3d& place_mm, const Eigen::Vector3d& angles_deg) {
  return {place_mm.x(), place_mm.y(), place_mm.z(), angles_deg.x(), angles_deg.y(), angles_deg.z()};
}

}  // namespace

InvesaliusSpace::InvesaliusSpace(const volume::VoxelGrid& any_order)
    : grid_(canonical(any_order)), spacing_(grid_.spacing_mm()) {
  turn_ = grid_.mri_from_voxel.linear() * spacing_.cwiseInverse().asDiagonal();
}

Eigen::Vector3d InvesaliusSpace::toWorld(const Eigen::Vector3d& p) const {
  const Eigen::Vector3d mm(p.x(), length_y_mm() - p.y(), p.z());
  return grid_.mri_from_voxel * mm.cwiseQuotient(spacing_);
}

Eigen::Vector3d InvesaliusSpace::fromWorld(const Eigen::Vector3d& p) const {
  const Eigen::Vector3d mm = (grid_.mri_from_voxel.inverse() * p).cwiseProduct(spacing_);
  return {mm.x(), length_y_mm() - mm.y(), mm.z()};
}

InvesaliusNumbers InvesaliusSpace::markerOf(const Eigen::Isometry3d& mri_T_coil) const {
  const Eigen::Matrix3d theirs = mri_T_coil.linear() * axesOf(CoilAxes::invesalius);
  return numbersOf(fromWorld(mri_T_coil.translation()), fixedAngles_deg(turn_.transpose() * theirs));
}

Eigen::Matrix3d turnOfFixedAngles(const Eigen::Vector3d& angles_deg) {
  const Eigen::Vector3d a = angles_deg * kRadPerDeg;
  return (Eigen::AngleAxisd(a.z(), Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(a.y(), Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(a.x(), Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

Eigen::Vector3d fixedAngles_deg(const Eigen::Matrix3d& r) {
  const double across = std::hypot(r(0, 0), r(1, 0));
  const Eigen::Vector3d angles =
      across > 1e-9 ? Eigen::Vector3d(std::atan2(r(2, 1), r(2, 2)), std::atan2(-r(2, 0), across),
                                      std::atan2(r(1, 0), r(0, 0)))
                    : Eigen::Vector3d(std::atan2(-r(1, 2), r(1, 1)), std::atan2(-r(2, 0), across), 0.0);
  return angles * kDegPerRad;
}

InvesaliusNumbers trackerNumbers(const Eigen::Isometry3d& tracker_T_tool) {
  // Turning axes z, y, x are the fixed axes x, y, z with the angles in the other order.
  return numbersOf(tracker_T_tool.translation(), fixedAngles_deg(tracker_T_tool.linear()).reverse());
}

InvesaliusNumbers displacementNumbers(const Eigen::Isometry3d& target_T_coil) {
  const Eigen::Matrix3d& axes = axesOf(CoilAxes::invesalius);
  return numbersOf(axes.transpose() * target_T_coil.translation(),
                   fixedAngles_deg(axes.transpose() * target_T_coil.linear() * axes));
}

}  // namespace facenav::interop
