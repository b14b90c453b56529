#pragma once
// BrainQuality: what prepare itself thinks of its brain mask and surface, for the radiographer: how far the
// mask may be off, region by region, and how far the phi-theta picture lies from the true surface. In
// case.json, additive.

#include <string>
#include <vector>

namespace facenav::casefile {

struct RegionConfidence {
  std::string region;     // "left temporal pole"
  double confidence = 1;  // share of the region's surface whose place is certain to 2 mm, 0..1
  double doubt_mm = 0;    // 90 of 100 places of its surface are certain to this
};

struct BrainQuality {
  std::vector<RegionConfidence> regions;  // the most doubtful first; empty where the method states no doubt
  /// From every vertex of the true surface (the cortex with open sulci, cortex.vtp) to the phi-theta surface
  /// ..
  double surface_median_mm = 0, surface_p95_mm = 0;
  /// .. and from every vertex of the phi-theta surface to the true one (0 in cases of before this was kept).
  double model_median_mm = 0, model_p95_mm = 0;
};

}  // namespace facenav::casefile
