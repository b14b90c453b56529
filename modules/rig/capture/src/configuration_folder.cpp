#include "configuration_folder.h"

#include <cstdlib>

#include "facenav/core/error.h"

namespace facenav::capture {
namespace fs = std::filesystem;

fs::path configurationFolder(const std::string& remedy) {
  if (const char* configuration = std::getenv("XDG_CONFIG_HOME"); configuration && *configuration)
    return fs::path(configuration) / "facenav";
  if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".config" / "facenav";
  throw Error("this user has no home folder", "", remedy);
}

}  // namespace facenav::capture
