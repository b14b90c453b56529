#pragma once
// InVesalius's space and numbers, for its marker files and its relay. Its frame is that of the image in RAS
// order, in mm from the first voxel, with y mirrored for positions and not for rotations. A pose is six
// numbers: position (mm) and angles (degrees). Source: resources/doc/interop.md.

#include <Eigen/Geometry>
#include <array>

#include "facenav/volume/voxel_grid.h"

namespace facenav::interop {

/// x, y, z in mm, then three angles in degrees.
using InvesaliusNumbers = std::array<double, 6>;

class InvesaliusSpace {
 public:
  /// `any_order`: grid of the image as it is stored.
  explicit InvesaliusSpace(const volume::VoxelGrid& any_order);

  /// Point of its space in Mri, mm, and back.
  Eigen::Vector3d toWorld(const Eigen::Vector3d& p) const;
  Eigen::Vector3d fromWorld(const Eigen::Vector3d& p) const;
  /// Axes of the image in Mri, of unit length.
  const Eigen::Matrix3d& turn() const { return turn_; }
  /// A pose of FaceNav's Coil as a marker's numbers; angles about fixed x, y, z.
  InvesaliusNumbers markerOf(const Eigen::Isometry3d& mri_T_coil) const;

 private:
  double length_y_mm() const { return spacing_.y() * (grid_.size[1] - 1); }

  volume::VoxelGrid grid_;
  Eigen::Vector3d spacing_;
  Eigen::Matrix3d turn_;
};

/// Rotation of angles about fixed x, then y, then z, and back.
Eigen::Matrix3d turnOfFixedAngles(const Eigen::Vector3d& angles_deg);
Eigen::Vector3d fixedAngles_deg(const Eigen::Matrix3d& turn);
/// A pose in a tracker's frame: angles about z, then the turned y, then the turned x.
InvesaliusNumbers trackerNumbers(const Eigen::Isometry3d& tracker_T_tool);
/// Where the coil is as seen from the target, both in InVesalius's axes of the coil; angles about fixed x, y,
/// z.
InvesaliusNumbers displacementNumbers(const Eigen::Isometry3d& target_T_coil);

}  // namespace facenav::interop
