#pragma once
// How well a pose explains the cloud, as a likelihood: each point is the patient's skin, off by misfit of a
// size that is the same all over the face, or something before the skin (hair, a hand, a coil), which is
// common above the hairline and rare on the face, and hardly ever behind it. What a sum of residuals cannot
// tell: a pose midway between face and hair fits all of it loosely, the right one fits the bare skin closely.

#include "face_regions.h"
#include "field_fit.h"

namespace facenav::registration {

class SkinLikelihood {
 public:
  /// For the `points` of the cloud, in their order. Patches of 25 mm count as independent, since misfit
  /// reaches that far.
  SkinLikelihood(const ScalpField& scalp, const PointCloud<Camera>& face, const std::vector<int>& points);

  /// Logarithm of the likelihood of the matches of all points at a pose; differences tell poses apart.
  double operator()(const std::vector<PointMatch>& matches) const;

 private:
  FaceRegions regions_;
  std::vector<float> weights_;  // one per point; they sum to the number of patches
};

}  // namespace facenav::registration
