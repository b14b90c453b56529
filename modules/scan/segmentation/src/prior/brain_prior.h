#pragma once
// The learned brain prior of a scan of any contrast: the probability of brain (tissue with closed sulci) at
// each place. The network sees a window of 192 x 224 x 192 mm. Windows side by side cover the scan; the one
// with most brain is moved until the brain is in its middle, whatever neck, shoulders or air the scan holds.

#include <optional>

#include "prior/prior_network.h"

namespace facenav::segmentation {

struct BrainPrior {
  // Shares 0..1 on a RAS grid of 2 mm with the extent of the last window. Air: also pads, earphones and haze.
  volume::Volume brain, fluid, air;
  volume::Mask mask() const;  // Voxels of 0.5 and more, in one piece, without holes.
};

/// Finds the brain. `working`: RAS, voxels of 1 mm, air about 0. nullopt if the network sees less brain than
/// an infant's.
std::optional<BrainPrior> findBrainPrior(const PriorNetwork& network, const volume::Volume& working);

/// brain_prior/weights.fnbp of core's dataFolder(), read once in a process; null if the file is missing or
/// damaged.
struct InstalledPrior {
  std::optional<PriorNetwork> network;
  std::string fault;  // reason why there is no prior
};
const InstalledPrior& installedPrior();

}  // namespace facenav::segmentation
