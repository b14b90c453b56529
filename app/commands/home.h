#pragma once
// `facenav export CASE --as home`: a case that goes home as one file.

#include <filesystem>
#include <string>

#include "commands/coil_option.h"
#include "context.h"
#include "facenav/home/home_case.h"

namespace facenav::app {

struct HomeExportRequest {
  std::filesystem::path output;
  std::string target, by;
  CoilChoice coil;
  bool replaces = false;
};

/// Exports the case. Throws Error as steps::exportHome does, and if the file exists.
void exportHomeCase(Context& context, const casefile::CaseStore& store, const HomeExportRequest& request);

}  // namespace facenav::app
