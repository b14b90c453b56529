#pragma once
// Likelihood of inside and outside of an outline from the scan's intensities, place by place: histograms of
// both sides within some millimetres of the outline, on a lattice; the logarithm of their ratio at each
// voxel's value. Works with any contrast and uneven shading.

#include "facenav/segmentation/prior_use.h"
#include "facenav/volume/volume.h"

namespace facenav::segmentation {

/// Signed distance of each voxel from the outline, mm, > 0 inside.
std::vector<float> depthBelow(const volume::Mask& outline);

/// Log likelihood ratio of inside to outside, averaged over neighbours; 0 further than `use.sample_mm` from
/// the outline. `image`: cubic voxels. `depth_mm`: on its grid.
volume::Volume localEvidence(const volume::Volume& image, const std::vector<float>& depth_mm,
                             const PriorUse& use);

}  // namespace facenav::segmentation
