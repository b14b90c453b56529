#pragma once
// The skin's fit, part of the face by part, for people: where the live skin lies outside or inside of the
// MRI's. Data flow: AlignmentResult (signed residuals) -> regions in words; the map itself are the residuals
// at their points.

#include <string>
#include <vector>

#include "facenav/registration/aligner.h"

namespace facenav::registration {

struct RegionFit {
  std::string region;      // "left cheek": the patient's left
  double offset_mm = 0.0;  // median signed residual: positive where the live skin lies outside the MRI's
  double foreign = 0.0;    // share of the points there that did not count in the fit (hair, a hand)
  int points = 0;
};

/// Regions with at least 50 measured points, the one that fits worst first.
std::vector<RegionFit> fitByRegion(const ScalpField& scalp, const PointCloud<Camera>& face,
                                   const AlignmentResult& alignment);

/// "left cheek 1.2 mm outside the MRI's skin", "forehead covered (hair or an object)".
std::string inWords(const RegionFit& fit);

}  // namespace facenav::registration
