#pragma once
// The skin's fit by region of the face, in words for users: where the live skin lies outside or inside the
// MRI's. Data flow: AlignmentResult (signed residuals) -> regions in words. The residuals at their points are
// the map.

#include <string>
#include <vector>

#include "facenav/registration/aligner.h"

namespace facenav::registration {

struct RegionFit {
  std::string region;      // "left cheek": the patient's left
  double offset_mm = 0.0;  // median signed residual: positive where the live skin lies outside the MRI's
  double foreign = 0.0;    // share of the region's points that the fit did not use (hair, a hand)
  int points = 0;
};

/// Regions with at least 50 measured points, the one that fits worst first.
std::vector<RegionFit> fitByRegion(const ScalpField& scalp, const PointCloud<Camera>& face,
                                   const AlignmentResult& alignment);

/// "left cheek 1.2 mm outside the MRI's skin", "forehead covered (hair or an object)".
std::string inWords(const RegionFit& fit);

}  // namespace facenav::registration
