#pragma once
// The coil that a case is planned for: CASE/coil.json, a copy of the coil's own file, so that planning does
// not change when the original does. Its contact outline rests on the head. This is the one place that
// decides which outline window and command line use.

#include <filesystem>
#include <string>

#include "facenav/guidance/coil_plate.h"

namespace facenav::casefile {

struct CaseCoil {
  std::string name;  // of its file; empty: none stated, or the default
  guidance::CoilPlate plate = guidance::figureOfEight();
  bool is_default = true;  // the case names no coil
};

/// A common figure-of-eight coil where the case has none. Throws Error naming file and key.
CaseCoil coilOf(const std::filesystem::path& case_folder);
/// The case is planned for this coil from now on; its targets stay as they are until they are edited. Throws
/// Error, and changes nothing, if the file cannot be read.
void setCoil(const std::filesystem::path& case_folder, const std::filesystem::path& coil_json);

}  // namespace facenav::casefile
