#pragma once
// Scans whose air was set to one value below a threshold (many archives and templates). That cuts off the
// skin's blurred edge: an artificial step, as steep as skin and up to 2 mm outside it.

#include <optional>

#include "facenav/volume/volume.h"

namespace facenav::surface {

/// Raises the scan's air to that threshold, so that the step vanishes. nullopt if the air outside `head` does
/// not have one value.
std::optional<volume::Volume> withoutMaskStep(const volume::Volume& scan, const volume::Mask& head);

}  // namespace facenav::surface
