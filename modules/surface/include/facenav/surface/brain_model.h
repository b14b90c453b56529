#pragma once
// BrainModel: the phi-theta textured brain (paper, section 6). SphericalMap is the 180 x 180 array of equations 6-8;
// theta is atan2 over the full 360 degrees, since the paper's arccos folds front onto back.

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "facenav/core/task_monitor.h"
#include "facenav/surface/triangle_mesh.h"
#include "facenav/volume/volume.h"

namespace facenav::surface {

/// Angles of a direction from the brain's centre: phi = acos(y / r) in 0..pi, theta = atan2(z, x) in -pi..pi, with the
/// paper's x, y, z (y is the polar axis; which Mri axis that is stands in brain_model.cpp and the module's README).
struct SphericalAngles {
  double phi_rad, theta_rad;
};

struct SphericalMap {
  int rows = 180, columns = 180;             // phi x theta
  Point<Mri> centre;
  std::vector<double> radius_mm;             // rows x columns: the surface along that direction
  std::vector<std::uint8_t> colour;          // rows x columns: grey value of the outermost brain voxel of the bin
};

SphericalAngles toAngles(const Point<Mri>& p, const Point<Mri>& centre);

struct BrainModel {
  SphericalMap map;
  TriangleMesh mesh;                                     // closed at seam and poles
  std::vector<Eigen::Vector2f> texture_coordinates;      // one per vertex, 0..1, origin bottom-left as VTK wants it
};

struct BrainModelOptions {
  int rows = 180, columns = 180;
  double peel_mm = 2.0;                                  // texture is taken up to this far below the surface
};

BrainModel buildBrainModel(const volume::Volume& volume, const volume::Mask& brain, const BrainModelOptions& options,
                           TaskMonitor& monitor);
/// brain.vtp + brain_texture.png beside it. Whole files.
void writeBrain(const BrainModel& brain, const std::filesystem::path& vtp, const std::filesystem::path& texture_png);
BrainModel readBrain(const std::filesystem::path& vtp, const std::filesystem::path& texture_png);

}  // namespace facenav::surface
