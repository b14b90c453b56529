#pragma once
// Pulses in the 3-D scene: their marks by a column's value, and the pictures of them for the report.

#include <optional>
#include <vector>

#include "facenav/report/pulse_columns.h"
#include "facenav/report/session_report.h"
#include "facenav/scene/pulse_layer.h"

namespace facenav::steps {

/// The least and the largest value of the pulses that are not excluded; signed columns (depth, twist) alike.
/// Nothing where none has a value.
std::optional<scene::ColourRange> rangeOf(const std::vector<casefile::ReviewedPulse>& pulses,
                                          report::PulseColumn column);

/// One mark per pulse with a pose, coloured by its value (grey: it has none). `places`: as of placesOn
/// (pulse_map.h). `chosen`: number of a pulse.
std::vector<scene::PulseMark> marksOf(const std::vector<casefile::ReviewedPulse>& pulses,
                                      const std::vector<std::optional<Point<Mri>>>& places,
                                      report::PulseColumn column, std::optional<int> chosen = {});

/// Pulses on cortex and scalp, coloured by their error, from the target's side and from above; with MEPs also
/// their map. Empty without an X display (scene/display.h), or where no pulse has a pose. On the thread that
/// draws. `places`: as of placesOn with the brain model, if they are known already.
std::vector<report::ReportPicture> pulsePictures(const casefile::CaseStore& store,
                                                 const casefile::KeptSession& session,
                                                 std::vector<std::optional<Point<Mri>>> places = {});

}  // namespace facenav::steps
