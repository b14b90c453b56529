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

/// On the part of the grid of `working` that holds the brain.
/// `inwards`: log odds that a place needs to be brain.
RefinedPrior refinedPrior(const volume::Volume& working, const BrainPrior& prior, const PriorUse& use,
                          double inwards = 0);
/// With the settings for scans that are no T1.
RefinedPrior refinedForOtherContrast(const volume::Volume& working, const BrainPrior& prior, PriorUse use);

}  // namespace facenav::segmentation
