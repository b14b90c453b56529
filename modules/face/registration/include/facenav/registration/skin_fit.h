#pragma once
// The skin's fit by region of the face, in words for users: where the live skin lies outside or inside the
// MRI's. Data flow: AlignmentResult (signed residuals) -> regions in words.

#include <string>
#include <vector>

#include "facenav/registration/aligner.h"

namespace facenav::registration {

struct RegionFit {
  std::string region;      // for example "left cheek", the patient's left
  double offset_mm = 0.0;  // median signed residual; positive: live skin outside the MRI's
  double foreign = 0.0;    // share of the region's points that the fit did not use (hair, a hand)
  int points = 0;
};

/// Regions with at least 50 measured points, the worst fit first.
std::vector<RegionFit> fitByRegion(const ScalpField& scalp, const PointCloud<Camera>& face,
                                   const AlignmentResult& alignment);

/// Text for users: "left cheek 1.2 mm outside the MRI's skin", "forehead covered (hair or an object)".
std::string inWords(const RegionFit& fit);

}  // namespace facenav::registration
