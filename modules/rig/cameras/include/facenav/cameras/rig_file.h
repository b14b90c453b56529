#pragma once
// Optional content of stereo.yml beside the rig (resources/doc/formats.md: board, views, created; and the
// effect at the head: effect_distance_mm, effect_point_mm, effect_depth_mm, effect_length_mm,
// effect_motion_mm, effect_motion_deg).

#include <filesystem>
#include <optional>
#include <string>

#include "facenav/cameras/head_effect.h"
#include "facenav/cameras/stereo_rig.h"

namespace facenav::cameras {

struct CalibrationNotes {
  std::string board;         // "9x6, 25 mm"
  std::optional<int> views;  // number of pairs used
  std::string created;       // UTC, ISO 8601
  std::optional<HeadEffect> at_head;
};

/// Writes the whole stereo.yml, with E, F (of undistorted pixels) and the notes that are not empty.
void writeRig(const StereoRig& rig, const std::filesystem::path& path, const CalibrationNotes& notes);

}  // namespace facenav::cameras
