#pragma once
// The place in the head that a finding of the import check speaks of, so that the window can go there.

#include <optional>
#include <string>

#include "facenav/atlas/atlas_map.h"
#include "facenav/surface/scalp_surface.h"

namespace facenav::steps {

/// The place that `finding` speaks of: nose, an ear's side, the top of the head, or the middle of a region of
/// the brain (with the case's atlas). nullopt for findings on the scan as a whole.
std::optional<Point<Mri>> placeOfFinding(const std::string& finding, const surface::ScalpSurface& scalp,
                                         const atlas::AtlasMap* atlas);

}  // namespace facenav::steps
