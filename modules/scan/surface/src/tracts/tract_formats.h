#pragma once
// One reader for each format of tracts. Private to surface.

#include "facenav/core/error.h"
#include "facenav/surface/tract_files.h"

namespace facenav::surface {

TractLines readTrk(const std::filesystem::path& path);
TractLines readTck(const std::filesystem::path& path);
TractLines readTrx(const std::filesystem::path& path);
TractLines readVtkLines(const std::filesystem::path& path);

/// Refuses a damaged file of tracts.
[[noreturn]] inline void refuseTracts(const std::filesystem::path& path, const std::string& what) {
  throw Error("the tracts cannot be read: " + what, path.string(), "copy or export the file again");
}

}  // namespace facenav::surface
