#pragma once
// BrainQuality: how certain prepare's brain mask and surface are, for the radiographer: the possible error of
// the mask in each region, and the distance of the phi-theta surface from the true one. Stored in case.json
// as an additive key.

#include <string>
#include <vector>

namespace facenav::casefile {

struct RegionConfidence {
  std::string region;     // "left temporal pole"
  double confidence = 1;  // share of the region's surface whose position is certain to 2 mm, 0..1
  double doubt_mm = 0;    // 90 % of its surface is certain to this distance
};

struct BrainQuality {
  std::vector<RegionConfidence> regions;  // least certain first; empty if the method gives no uncertainty
  /// Distance from each vertex of the true surface (cortex with open sulci, cortex.vtp) to the phi-theta
  /// surface.
  double surface_median_mm = 0, surface_p95_mm = 0;
  /// Distance from each vertex of the phi-theta surface to the true surface (0 in older cases).
  double model_median_mm = 0, model_p95_mm = 0;
};

}  // namespace facenav::casefile
