#pragma once
// The coil that a case is planned for: CASE/coil.json, a copy of the coil's own file, so that planning does
// not change when the original does. Window and command line both get the contact outline from here.

#include <filesystem>
#include <string>

#include "facenav/guidance/coil_plate.h"

namespace facenav::casefile {

struct CaseCoil {
  std::string name;  // name in its file; empty: none given, or the default
  guidance::CoilPlate plate = guidance::figureOfEight();
  bool is_default = true;  // true if the case names no coil
};

/// Returns the case's coil, or a common figure-of-eight coil if it has none. Throws Error naming file and
/// key.
CaseCoil coilOf(const std::filesystem::path& case_folder);
/// Sets the coil that the case is planned for; its targets do not change until they are edited. Throws Error,
/// and changes nothing, if the file cannot be read.
void setCoil(const std::filesystem::path& case_folder, const std::filesystem::path& coil_json);

}  // namespace facenav::casefile
