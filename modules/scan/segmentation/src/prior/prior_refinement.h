#pragma once
// The learned prior's outline, moved within a narrow band to where the scan's own intensities change.

#include "facenav/segmentation/prior_use.h"
#include "facenav/segmentation/segmenter.h"
#include "prior/brain_prior.h"

namespace facenav::segmentation {

struct RefinedPrior {
  volume::Mask outline;               // the prior's own, on the grid of `mask`
  volume::Mask mask;                  // refined
  std::vector<BoundaryDoubt> doubts;  // of its surface
};

/// On the part of the grid of `working` that holds the brain: by what lies inside and outside of the outline.
/// The mask alone: what growth is compared with.
volume::Mask refinedMask(const volume::Volume& working, const BrainPrior& prior, const PriorUse& use);
/// The same with its doubts.
RefinedPrior refinedPrior(const volume::Volume& working, const BrainPrior& prior, const PriorUse& use);
/// Likewise, by the classes tissue, fluid and the rest (tissue_mixture.h): for scans that are no clear T1.
/// The doubts are scores (stated_doubt.h).
RefinedPrior refinedByTissue(const volume::Volume& working, const BrainPrior& prior, const PriorUse& use);

}  // namespace facenav::segmentation
