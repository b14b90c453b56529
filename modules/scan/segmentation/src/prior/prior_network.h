#pragma once
// The brain prior's network (resources/training/brain_prior/network.py), forward only: a U-Net on a grid of 8
// mm whose voxels carry 2 x 2 x 2 voxels of 4 mm as channels.

#include <array>
#include <filesystem>
#include <vector>

#include "facenav/volume/volume.h"
#include "prior/prior_weights.h"

namespace facenav::segmentation {

constexpr std::array<int, 3> kPriorSize{48, 56, 48};  // voxels of 4 mm, RAS
enum PriorClass { kPriorAir, kPriorBrain, kPriorFluid, kPriorOther, kPriorClasses };

/// Probability of each class, voxel by voxel of a window.
using PriorShares = std::array<std::vector<float>, kPriorClasses>;

class PriorNetwork {
 public:
  /// Throws Error as readPriorWeights does, and where the tensors are not this network's.
  explicit PriorNetwork(const std::filesystem::path& weights);
  /// Probabilities of all classes. `window`: kPriorSize, black 0 to white 1.
  PriorShares shares(const volume::Volume& window) const;

 private:
  std::vector<PriorTensor> tensors_;
};

}  // namespace facenav::segmentation
