#pragma once
// The deformable surface of S. M. Smith, "Fast robust automated brain extraction", Human Brain Mapping 17
// (2002) 143-155. A tessellated sphere inside the brain grows outwards under smoothness and a local threshold
// between brain and the tissue along the inward normal.

#include <Eigen/Core>
#include <vector>

#include "facenav/core/task_monitor.h"
#include "facenav/volume/volume.h"

namespace facenav::segmentation {

struct BetSphere {
  Eigen::Vector3d centre_mm;  // Mri
  double radius_mm = 70;      // radius of a ball with the brain's volume
};

struct BetIntensities {
  float t2 = 0, t = 0, t98 = 0;  // robust minimum, brain/background threshold, robust maximum
  float median = 0;              // median within the sphere: between grey and white matter
};

struct BetOptions {
  double fractional_threshold = 0.5;  // b_t: a smaller value gives a larger brain
  int iterations = 1000;
  int subdivisions = 4;           // 10 * 4^n + 2 vertices
  double smoothing_factor = 1.0;  // > 1: stiffer
};

struct BetSurface {
  std::vector<Eigen::Vector3d> vertices_mm;  // Mri
  std::vector<Eigen::Vector3i> triangles;    // outward
};

BetIntensities betIntensities(const volume::Volume& image, const BetSphere& sphere, float t2, float t98);
/// Grows the surface. `image`: cubic voxels of about 1 to 2 mm, RAS order. Throws Cancelled.
BetSurface evolveBet(const volume::Volume& image, const BetSphere& start, const BetIntensities& intensities,
                     const BetOptions& options, TaskMonitor& monitor);
/// Voxels enclosed by the surface, on `grid`.
volume::Mask enclosed(const BetSurface& surface, const volume::VoxelGrid& grid);

}  // namespace facenav::segmentation
