#pragma once
// Turns the uncertainty at points of the brain mask's surface into words about its regions, for the
// radiographer.

#include "facenav/atlas/atlas_map.h"
#include "facenav/atlas/brain_template.h"
#include "facenav/casefile/brain_quality.h"
#include "facenav/segmentation/segmenter.h"

namespace facenav::steps {

/// Confidence of each lobe of the atlas, the least certain first. Without map or template: the whole brain as
/// one region. Regions with fewer than 30 points are left out.
std::vector<casefile::RegionConfidence> regionConfidence(
    const std::vector<segmentation::BoundaryDoubt>& doubts, const atlas::AtlasMap* map,
    const atlas::BrainTemplate* atlas);

/// Findings for at most three uncertain regions, the worst first: "look at the left temporal pole: the mask's
/// edge is uncertain by 4 mm there (confidence 0.62)".
std::vector<std::string> whereToLook(const std::vector<casefile::RegionConfidence>& regions);

}  // namespace facenav::steps
