#pragma once
// A page to print: the coil's markers at true size (SVG, millimetres, A4), each with its name and the white
// margin that the tracker needs. A ruler of 100 mm shows whether the printer scaled the page. Marker's x
// points right on the upright page, its y down.

#include <filesystem>
#include <string>

#include "facenav/coil_tracking/coil_tracker.h"

namespace facenav::coil_tracking {

/// Throws Error if a marker with its margin is wider than the page, or the markers do not fit on one page.
std::string markerPageSvg(const CoilModel& coil);
/// Writes the whole file or nothing. Throws Error.
void writeMarkerPage(const CoilModel& coil, const std::filesystem::path& path);

}  // namespace facenav::coil_tracking
