#pragma once
// What `facenav plan` prints: targets, presets, landmarks, measures of the head; as lines, or as JSON.

#include "facenav/casefile/protocol.h"
#include "facenav/guidance/compare_targets.h"
#include "facenav/plan/presets.h"

namespace facenav::app {

void printPresets(bool is_json);
void printLandmarks(const surface::ScalpLandmarks& landmarks, bool is_json);
/// Prints tape measures, the EEG sites with their errors, and Beam F3 and F4.
void printMeasures(const steps::HeadMeasures& measures, bool is_json);
/// Prints the targets and the contact of the plate with the head.
void printPlan(const guidance::TreatmentPlan& plan, const steps::PlannedHead& head, bool is_json);
void printDifference(const std::string& first, const std::string& second,
                     const guidance::TargetDifference& difference, double along_scalp_mm, bool is_json);
void printProtocol(const std::optional<casefile::Protocol>& protocol, bool is_json);

}  // namespace facenav::app
