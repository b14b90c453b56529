#pragma once
// `facenav evaluate rigs`: tests health::diagnosePair on images of a known rig: unchanged; with the right
// image from another moment; exchanged; with another rig's calibration; and with a calibration whose right
// camera was rotated or shifted.

#include <filesystem>
#include <string>
#include <vector>

#include "facenav/core/task_monitor.h"
#include "facenav/health/pair_diagnosis.h"

namespace facenav::app {

struct RigFaultRow {
  std::string kind;  // "right rig", "out of step", "swapped", "other rig", "turned 0.25 deg", ..
  std::string pictures, calibration;
  health::RigState expected = health::RigState::holds;
  health::PairDiagnosis said;
};

/// Runs the tests. `pictures`: files <camera>_<moment>.jpg|png, cameras named by one letter; `rigs`:
/// <a><b>_stereo.yml. Throws Error if no rig has pictures of both its cameras, Cancelled.
std::vector<RigFaultRow> rigFaults(const std::filesystem::path& pictures, const std::filesystem::path& rigs,
                                   TaskMonitor& monitor);

/// Table per kind: tried, named correctly, not named, named wrongly; then every wrong row.
std::string sidesTable(const std::vector<RigFaultRow>& rows);

}  // namespace facenav::app
