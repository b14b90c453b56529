#pragma once
// What the doubt of an outline that was fitted by tissue (refinedByTissue) is stated as: so that in scans of
// one contrast as many places are stated in each band (1 2 3 5 8 mm) as have errors there.

#include <vector>

#include "contrast_seen.h"
#include "facenav/segmentation/segmenter.h"

namespace facenav::segmentation {

/// What the fit shows at one place of its surface, mm.
struct PlaceEvidence {
  float prior_width_mm;  // distances to the prior's levels 0.25 and 0.75, together
  float moved_mm;        // distance to the prior's outline
  float fit_width_mm;    // distances to where the fitted log odds are -1 and 1, together
};

/// Rises with the error to be expected; compares places of one scan.
float doubtScore(const PlaceEvidence& evidence);

/// Scores -> millimetres, 0.2 to 8. A scan whose scores are all higher than usual in its contrast is stated
/// only a little worse: across scans the score tells little of the error.
void stateDoubts(std::vector<BoundaryDoubt>& scores, ContrastKind kind);

/// Where `other` (the refined prior's mask) has its outline elsewhere, the doubt is at least that far. A
/// place beyond the grid of `other` is at least as far from that outline as from the grid.
void raiseDoubts(std::vector<BoundaryDoubt>& doubts, const volume::Mask& other);

}  // namespace facenav::segmentation
