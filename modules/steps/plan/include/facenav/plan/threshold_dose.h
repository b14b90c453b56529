#pragma once
// The motor threshold of a case with the hotspot where it was found, and the output by field that follows
// from it (cortex_field.h). For information; nothing is set.

#include <filesystem>
#include <optional>
#include <string>

#include "facenav/plan/head_field.h"

namespace facenav::steps {

struct HotspotThreshold {
  guidance::Target hotspot;  ///< where it was found; its pose as planned
  double threshold_pct = 0;  ///< of the maximal output
  std::string muscle = {};
};
bool operator==(const HotspotThreshold& a, const HotspotThreshold& b);

/// The newest finished search of the case that recorded its target; nothing: there is none.
std::optional<HotspotThreshold> hotspotThreshold(const std::filesystem::path& case_folder);

/// Output that gives a target, at its planned pose, the field of the hotspot at its threshold.
struct ThresholdDose {
  std::string hotspot;
  double threshold_pct = 0;
  double at_hotspot = 0;  ///< |E|, V/m at 1 A/us
  double output_pct = 0;  ///< may exceed 100
};
/// `at_target`: |E| at the target at its planned pose, V/m at 1 A/us. Throws Error as doseByField_pct does.
ThresholdDose thresholdDose(const ReadHead& head, const efield::CoilDipoles& coil,
                            const HotspotThreshold& threshold, double at_target);

}  // namespace facenav::steps
