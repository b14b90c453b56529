#include "context.h"

#include <cstdlib>

namespace facenav::app {

namespace fs = std::filesystem;

fs::path Context::cacheFolder() const {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return fs::path(value ? value : "");
  };
  if (const auto named = variable("FACENAV_CACHE"); !named.empty()) return named;
  const fs::path in_build =
      program.parent_path().parent_path().parent_path() / "cache";  // <build>/release/bin/facenav
  std::error_code fault;
  if (fs::is_directory(in_build / "brainbrowser", fault)) return in_build;
  if (const auto users = variable("XDG_CACHE_HOME"); users.is_absolute()) return users / "facenav";
  return variable("HOME") / ".cache" / "facenav";
}

}  // namespace facenav::app
