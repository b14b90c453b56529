#pragma once
// Locates the pulses of a session on a surface of the brain, and maps their MEPs.

#include <optional>
#include <vector>

#include "facenav/casefile/session_pulses.h"
#include "facenav/guidance/mep_map.h"

namespace facenav::report {

/// Returns, for each pulse, where the coil's axis meets the surface; nothing without a pose, or where it
/// misses. Takes about a millisecond a pulse for the brain model.
std::vector<std::optional<Point<Mri>>> placesOn(const surface::TriangleMesh& surface,
                                                const std::vector<casefile::ReviewedPulse>& pulses);

/// Maps the MEPs of pulses that are not excluded and have a position and an MEP. `places`: as returned by
/// placesOn.
std::optional<guidance::MepMap> mepMapOf(const surface::TriangleMesh& surface,
                                         const std::vector<casefile::ReviewedPulse>& pulses,
                                         const std::vector<std::optional<Point<Mri>>>& places);

}  // namespace facenav::report
