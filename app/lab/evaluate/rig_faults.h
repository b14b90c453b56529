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

/// `pictures`: files <camera>_<moment>.jpg|png, cameras named by one letter; `rigs`: <a><b>_stereo.yml.
/// Throws Error where no rig finds pictures of both its cameras, Cancelled.
std::vector<RigFaultRow> rigFaults(const std::filesystem::path& pictures, const std::filesystem::path& rigs,
                                   TaskMonitor& monitor);

/// Per kind: tried, named rightly, not named, named wrongly; then every row that is not right.
std::string sidesTable(const std::vector<RigFaultRow>& rows);

}  // namespace facenav::app
