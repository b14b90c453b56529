#pragma once
// Moves the learned prior's outline within a narrow band to where the scan's own intensities change.

#include "facenav/segmentation/prior_use.h"
#include "facenav/segmentation/segmenter.h"
#include "prior/brain_prior.h"

namespace facenav::segmentation {

struct RefinedPrior {
  volume::Mask outline;               // the prior's own outline, on the grid of `mask`
  volume::Mask mask;                  // refined outline
  std::vector<BoundaryDoubt> doubts;  // doubts of its surface
};

/// Refines by the intensities inside and outside of the outline, on the part of the grid of `working` that
/// contains the brain. Returns the mask alone, with which growth is compared.
volume::Mask refinedMask(const volume::Volume& working, const BrainPrior& prior, const PriorUse& use);
/// Refines as refinedMask(), and adds the doubts.
RefinedPrior refinedPrior(const volume::Volume& working, const BrainPrior& prior, const PriorUse& use);
/// Refines by the classes tissue, fluid and the rest (tissue_mixture.h): for scans that are no clear T1. The
/// doubts are scores (stated_doubt.h).
RefinedPrior refinedByTissue(const volume::Volume& working, const BrainPrior& prior, const PriorUse& use);

}  // namespace facenav::segmentation
