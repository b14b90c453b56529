#pragma once
// The charts of a session: histogram of a number, a number over time, positions of the coil.

#include <optional>
#include <string>
#include <vector>

#include "facenav/casefile/session_pulses.h"
#include "facenav/report/chart.h"
#include "facenav/report/pulse_columns.h"

namespace facenav::report {

/// Draws bars of width `bin` from 0, with a dashed line at `limit`. The last of at most 40 bars includes all
/// larger values.
Chart histogramChart(const std::string& title, const std::string& x_label, const std::vector<double>& values,
                     double bin, double limit, int width = 340, int height = 260);

struct PlacedPulse {
  double x_mm = 0, y_mm = 0;  // the coil's centre in Target
  bool is_on_target = false, is_excluded = false;
};
/// Draws the coil's centres around the target, seen along its z from above, with a dashed circle of
/// `limit_mm`.
Chart placesChart(const std::string& title, const std::vector<PlacedPulse>& pulses, double limit_mm);

/// Draws a mark per pulse: minutes since the first pulse, against the column.
Chart driftChart(const std::vector<casefile::ReviewedPulse>& pulses, PulseColumn column, int width = 340,
                 int height = 260);
/// Histogram of the pulses that are not excluded, with a bin that suits the values. No bars without values.
Chart histogramOf(const std::vector<casefile::ReviewedPulse>& pulses, PulseColumn column, int width = 340,
                  int height = 260);
/// Value of the dashed line: 2 mm for the error, the tolerance for the tilt; nothing for others.
std::optional<double> limitOf(PulseColumn column);

}  // namespace facenav::report
