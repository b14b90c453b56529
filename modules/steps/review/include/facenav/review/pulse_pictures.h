#pragma once
// Pulses in the 3-D scene: their marks coloured by a column's value, and pictures of them for the report.

#include <optional>
#include <vector>

#include "facenav/report/pulse_columns.h"
#include "facenav/report/session_report.h"
#include "facenav/scene/pulse_layer.h"

namespace facenav::steps {

/// Smallest and largest value of the pulses that are not excluded, for signed columns (depth, twist) alike.
/// Nothing if no pulse has a value.
std::optional<scene::ColourRange> rangeOf(const std::vector<casefile::ReviewedPulse>& pulses,
                                          report::PulseColumn column);

/// Makes one mark per pulse with a pose, coloured by its value (grey: it has none). `places`: from placesOn
/// (pulse_map.h). `chosen`: number of a pulse.
std::vector<scene::PulseMark> marksOf(const std::vector<casefile::ReviewedPulse>& pulses,
                                      const std::vector<std::optional<Point<Mri>>>& places,
                                      report::PulseColumn column, std::optional<int> chosen = {});

/// Draws the pulses on cortex and scalp, coloured by their error, from the target's side and from above; with
/// MEPs also their map. Empty without an X display (scene/display.h), or if no pulse has a pose. Call it on
/// the drawing thread. `places`: from placesOn with the brain model, if known already.
std::vector<report::ReportPicture> pulsePictures(const casefile::CaseStore& store,
                                                 const casefile::KeptSession& session,
                                                 std::vector<std::optional<Point<Mri>>> places = {});

}  // namespace facenav::steps
