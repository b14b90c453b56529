#pragma once
// A page to print: the coil's markers at true size (SVG, millimetres, A4), each with the white rim that the
// tracker needs, its name, and a ruler of 100 mm to check the printer's scale with. On the page the print
// reads upright: Marker's x runs right, its y down.

#include <filesystem>
#include <string>

#include "facenav/coil_tracking/coil_tracker.h"

namespace facenav::coil_tracking {

/// Throws Error when a marker with its rim is wider than the page, or the markers do not fit on one page.
std::string markerPageSvg(const CoilModel& coil);
/// A whole file. Throws Error.
void writeMarkerPage(const CoilModel& coil, const std::filesystem::path& path);

}  // namespace facenav::coil_tracking
