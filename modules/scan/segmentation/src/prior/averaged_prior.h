#pragma once
// Test-time averaging of the learned prior: the network sees the scan also with other intensity curves, a
// little larger, and turned. The mean of its shares errs less than one view (Wang et al. 2019, Aleatoric
// uncertainty estimation with test-time augmentation).

#include "prior/brain_prior.h"

namespace facenav::segmentation {

/// Returns `prior` (of four views) with its brain's shares averaged over eight more views of `working`. Takes
/// about a second on two cores. The shares of fluid and air do not change.
BrainPrior averagedPrior(const PriorNetwork& network, const volume::Volume& working, BrainPrior prior);

/// Curve that changes a window's values. The inverse leaves air dark.
enum class IntensityCurve { brighter, darker, inverted };
volume::Volume withCurve(volume::Volume window, IntensityCurve curve);

}  // namespace facenav::segmentation
