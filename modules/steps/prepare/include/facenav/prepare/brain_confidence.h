#pragma once
// Turns the uncertainty at places of the brain mask's surface into words about its regions: where the
// radiographer should look.

#include "facenav/atlas/atlas_map.h"
#include "facenav/atlas/brain_template.h"
#include "facenav/casefile/brain_quality.h"
#include "facenav/segmentation/segmenter.h"

namespace facenav::steps {

/// Per lobe of the atlas, the least certain first. Without map or template: the whole brain as one region.
/// Regions with fewer than 30 places are left out.
std::vector<casefile::RegionConfidence> regionConfidence(
    const std::vector<segmentation::BoundaryDoubt>& doubts, const atlas::AtlasMap* map,
    const atlas::BrainTemplate* atlas);

/// Findings in words for uncertain regions: "look at the left temporal pole: the mask's edge is uncertain by
/// 4 mm there (confidence 0.62)". At most three, the worst.
std::vector<std::string> whereToLook(const std::vector<casefile::RegionConfidence>& regions);

}  // namespace facenav::steps
