#pragma once
// What stereo.yml may say beside the rig (FORMATS.md: board, views, created), for people who look into the
// file.

#include <filesystem>
#include <string>

#include "facenav/stereo/stereo_rig.h"

namespace facenav::stereo {

struct CalibrationNotes {
  std::string board;    // "9x6, 25 mm"
  int views = 0;        // pairs used
  std::string created;  // UTC, ISO 8601
};

/// Writes stereo.yml whole, with E, F (of undistorted pixels) and the notes that are not empty.
void writeRig(const StereoRig& rig, const std::filesystem::path& path, const CalibrationNotes& notes);

}  // namespace facenav::stereo
