#include "facenav/prepare/brain_confidence.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "facenav/atlas/lobes.h"
#include "facenav/core/number_text.h"

namespace facenav::steps {
namespace {

constexpr double kCertain_mm = 2.0;       // one or two voxels: as good as drawn by hand
constexpr double kLookBelow = 0.8;        // regions with lower confidence are named
constexpr std::size_t kLeastPlaces = 30;  // of a region's surface
constexpr std::size_t kMostWords = 3;

casefile::RegionConfidence summed(const std::string& region, std::vector<float> doubts_mm) {
  std::sort(doubts_mm.begin(), doubts_mm.end());
  const auto certain = std::upper_bound(doubts_mm.begin(), doubts_mm.end(), float(kCertain_mm) + 1e-3f);
  return {region, double(certain - doubts_mm.begin()) / double(doubts_mm.size()),
          double(doubts_mm[std::size_t(0.9 * double(doubts_mm.size() - 1))])};
}

/// Each side has a sentence of its own, since the window translates whole sentences.
std::string lookAt(const std::string& region) {
  const std::string left = "left ", right = "right ";
  if (region.rfind(left, 0) == 0) return formatted("look at the left %s", region.c_str() + left.size());
  if (region.rfind(right, 0) == 0) return formatted("look at the right %s", region.c_str() + right.size());
  return "look at the " + region;
}

}  // namespace

std::vector<casefile::RegionConfidence> regionConfidence(
    const std::vector<segmentation::BoundaryDoubt>& doubts, const atlas::AtlasMap* map,
    const atlas::BrainTemplate* atlas) {
  std::map<std::string, std::vector<float>> by_region;
  if (map && atlas) {
    const atlas::LobeMap lobes(atlas->aal);
    for (const auto& doubt : doubts) {
      const std::string& lobe = lobes.at(map->toMni(doubt.place));
      by_region[lobe.empty() ? "brainstem and base" : lobe].push_back(doubt.doubt_mm);
    }
  } else {
    for (const auto& doubt : doubts) by_region["whole brain"].push_back(doubt.doubt_mm);
  }
  std::vector<casefile::RegionConfidence> regions;
  for (auto& [region, doubts_mm] : by_region)
    if (doubts_mm.size() >= kLeastPlaces) regions.push_back(summed(region, std::move(doubts_mm)));
  std::sort(regions.begin(), regions.end(), [](const auto& a, const auto& b) {
    return a.confidence != b.confidence ? a.confidence < b.confidence : a.region < b.region;
  });
  return regions;
}

std::vector<std::string> whereToLook(const std::vector<casefile::RegionConfidence>& regions) {
  std::vector<std::string> words;
  for (const auto& r : regions) {
    if (r.confidence >= kLookBelow || words.size() == kMostWords) break;
    words.push_back(lookAt(r.region) +
                    formatted(": the mask's edge is uncertain by %.0f mm there (confidence %.2f)",
                              std::ceil(r.doubt_mm), r.confidence));
  }
  return words;
}

}  // namespace facenav::steps
