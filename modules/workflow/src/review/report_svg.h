#pragma once
// The figures of a session's report as SVG text for a page: no file, no script. Shapes differ as well as
// colours, so that a black and white print tells them apart.

#include <string>
#include <vector>

namespace facenav::workflow {

/// Counts of `values` (>= 0) in bins of `bin`, with a dashed line at `limit`.
std::string histogramSvg(const std::string& title, const std::string& x_label,
                         const std::vector<double>& values, double bin, double limit);

struct PlacedPulse {
  double x_mm = 0, y_mm = 0;  // of the coil's centre in the target's axes
  bool is_on_target = false, is_excluded = false;
};
/// Seen from above the coil, with the target at the origin and a circle of `limit_mm`.
std::string placesSvg(const std::string& title, const std::vector<PlacedPulse>& pulses, double limit_mm);

}  // namespace facenav::workflow
