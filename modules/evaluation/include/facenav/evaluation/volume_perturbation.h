#pragma once
// VolumePerturbation: the same head as another scan might show it, to see that a mask holds still. Geometry
// by the grid alone where that is exact (a head turned in the scanner, another size); resampling by averages
// of trilinear samples. Noise is Rician, as in magnitude MR.

#include <string>
#include <vector>

#include "facenav/volume/volume.h"

namespace facenav::evaluation {

struct VolumePerturbation {
  std::string name;
  Eigen::Vector3d turn_deg =
      Eigen::Vector3d::Zero();  // about Mri's x, y or z axis, through the grid's centre
  double size = 1;              // of the head
  double spacing_mm = 0;        // resampled to cubes of this size; 0: as it is
  double neck_mm = 0;           // the lowest slice continued downwards
  double gain = 1;              // of all values
  double gamma = 1;             // of values over their 99th percentile: < 1 flattens contrast
  double bias = 0;              // smooth gain field, most of |log gain| within the head
  double noise = 0;             // sigma of both channels, share of the 98th percentile
  double scalp_noise = 0;       // more of it, further than 6 mm outside the brain
};

/// What another scan of the same head may differ by: +-20 degrees about each axis, 0.5 to 1.5 mm, gain,
/// noise, bias field. The mask must hold still (0.01 Dice).
std::vector<VolumePerturbation> standardPerturbations();
/// Heads of another kind: neck, child, big, low and high contrast, strong bias, noisy scalp.
std::vector<VolumePerturbation> hardHeads();

/// `brain`: where scalp noise keeps away from, on the volume's grid. Deterministic for a seed.
volume::Volume perturbed(const volume::Volume& volume, const volume::Mask& brain,
                         const VolumePerturbation& perturbation, unsigned seed);
/// A mask found in the perturbed volume, back on the original grid.
volume::Mask unperturbed(const volume::Mask& mask, const volume::VoxelGrid& original,
                         const VolumePerturbation& perturbation);

/// Likewise a place.
Point<Mri> unperturbed(const Point<Mri>& place, const volume::VoxelGrid& original,
                       const VolumePerturbation& perturbation);

}  // namespace facenav::evaluation
