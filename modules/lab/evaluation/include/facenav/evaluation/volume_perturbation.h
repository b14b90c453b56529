#pragma once
// VolumePerturbation: another scan of the same head, to test the stability of a mask. Geometry changes only
// the grid where that is exact (a head turned in the scanner, another size); resampling averages trilinear
// samples. Noise is Rician, as in magnitude MR.

#include <string>
#include <vector>

#include "facenav/volume/volume.h"

namespace facenav::evaluation {

struct VolumePerturbation {
  std::string name;
  Eigen::Vector3d turn_deg =
      Eigen::Vector3d::Zero();  // rotation about Mri's x, y or z axis, through the grid's centre
  double size = 1;              // of the head
  double spacing_mm = 0;        // resampled to cubes of this size; 0: not resampled
  double neck_mm = 0;           // length of a neck added by repeating the lowest slice
  double gain = 1;              // factor on all values
  double gamma = 1;             // applied to values / 99th percentile: < 1 flattens contrast
  double bias = 0;              // smooth gain field: largest |log gain| within the head
  double noise = 0;             // sigma in both channels, as a share of the 98th percentile
  double scalp_noise = 0;       // additional noise more than 6 mm outside the brain
};

/// Differences between scans of the same head: +-20 degrees about each axis, 0.5 to 1.5 mm voxels, gain,
/// noise, bias field. The mask must stay the same (0.01 Dice).
std::vector<VolumePerturbation> standardPerturbations();
/// Unusual heads: neck, child, large, low and high contrast, strong bias, noisy scalp.
std::vector<VolumePerturbation> hardHeads();

/// Perturbs a volume. `brain`: mask on the volume's grid; scalp noise is not added near it. Deterministic for
/// a seed.
volume::Volume perturbed(const volume::Volume& volume, const volume::Mask& brain,
                         const VolumePerturbation& perturbation, unsigned seed);
/// Maps a mask found in the perturbed volume back to the original grid.
volume::Mask unperturbed(const volume::Mask& mask, const volume::VoxelGrid& original,
                         const VolumePerturbation& perturbation);

/// Maps a point of the perturbed volume back to the original.
Point<Mri> unperturbed(const Point<Mri>& place, const volume::VoxelGrid& original,
                       const VolumePerturbation& perturbation);

}  // namespace facenav::evaluation
