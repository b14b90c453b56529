#pragma once
// Tissue against fluid and the rest, voxel by voxel, near the learned prior's outline. Each of the three
// classes has a histogram of intensities at each place of a lattice; the network's shares are the classes'
// probabilities in space. Histograms and responsibilities are estimated in turn (expectation-maximisation
// with a spatial prior: Ashburner and Friston 2005, here with histograms in place of Gaussians and no bias
// field, as the histograms are local).

#include "facenav/segmentation/prior_use.h"
#include "facenav/volume/volume.h"

namespace facenav::segmentation {

/// Limit of the log odds of a voxel.
constexpr float kMostLogOdds = 6;

/// Shares of the classes on one grid of cubic voxels; what is left to 1 is neither.
struct TissueShares {
  volume::Volume brain, fluid;
};

/// Log odds of tissue; further than `use.other_reach_mm` from the outline, the prior's own. `image`: the scan
/// on the shares' grid. `depth_mm`: signed distance of each voxel from the outline, > 0 inside.
std::vector<float> tissueLogOdds(const volume::Volume& image, const TissueShares& shares,
                                 const std::vector<float>& depth_mm, const PriorUse& use);

/// Log odds of a probability, limited to +-kMostLogOdds.
float logOddsOf(float probability);

}  // namespace facenav::segmentation
