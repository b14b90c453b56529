#include "context.h"

#include <cstdlib>

namespace facenav::app {

std::filesystem::path Context::cacheFolder() const {
  const char* cache = std::getenv("FACENAV_CACHE");
  if (cache && *cache) return cache;
  return program.parent_path().parent_path().parent_path() /
         "cache";  // <build>/release/bin/facenav -> <build>/cache
}

}  // namespace facenav::app
