#pragma once
// Runs the facenav command line tool. The test program is compiled with FACENAV_CLI, the tool's path.

#include <string>

#include "support/run_program.h"

namespace facenav::testing {

inline CommandResult runFacenav(const std::string& arguments, int timeout_s = 120) {
  return runProgram(FACENAV_CLI, arguments, timeout_s);
}

}  // namespace facenav::testing
