#pragma once
// Maps the doubt score of an outline that was fitted by tissue (refinedByTissue) to a calibrated error in mm:
// in scans of one contrast, each band (1 2 3 5 8 mm) is given to as many places as have such errors.

#include <vector>

#include "contrast_seen.h"
#include "facenav/segmentation/segmenter.h"

namespace facenav::segmentation {

/// Evidence of the fit at one place of its surface, mm.
struct PlaceEvidence {
  float prior_width_mm;  // distances to the prior's levels 0.25 and 0.75, together
  float moved_mm;        // distance to the prior's outline
  float fit_width_mm;    // distances to where the fitted log odds are -1 and 1, together
};

/// Rises with the error to be expected; compares places of one scan.
float doubtScore(const PlaceEvidence& evidence);

/// Converts scores to millimetres, 0.2 to 8. If all scores of a scan are higher than usual in its contrast,
/// the doubts increase only a little: the score hardly predicts differences of error between scans.
void stateDoubts(std::vector<BoundaryDoubt>& scores, ContrastKind kind);

/// Raises the doubt to the distance of the outline of `other` (the refined prior's mask). A place beyond the
/// grid of `other` is at least as far from that outline as from the grid.
void raiseDoubts(std::vector<BoundaryDoubt>& doubts, const volume::Mask& other);

}  // namespace facenav::segmentation
