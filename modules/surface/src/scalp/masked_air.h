#pragma once
// Scans whose air was set to one value at a threshold (many archives and templates): the skin's blurred edge
// is cut off there, and the cut is a step of its own, as steep as skin and up to 2 mm outside of it.

#include <optional>

#include "facenav/volume/volume.h"

namespace facenav::surface {

/// The scan with its air raised to the threshold at which it was cut, so that the edge runs out without a
/// step; nothing where the air outside `head` was not set to one value.
std::optional<volume::Volume> withoutMaskStep(const volume::Volume& scan, const volume::Mask& head);

}  // namespace facenav::surface
