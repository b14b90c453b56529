#include "facenav/core/data_folder.h"

#include <cstdlib>

namespace facenav {
inline namespace core {
namespace fs = std::filesystem;

fs::path programPath() {
  std::error_code fault;
  const auto path = fs::read_symlink("/proc/self/exe", fault);
  return fault ? fs::path("facenav") : path;
}

fs::path dataFolder() {
  if (const char* named = std::getenv("FACENAV_DATA"); named && *named) return named;
  const fs::path beside = programPath().parent_path().parent_path() / "share" / "facenav";
  std::error_code fault;
  return fs::is_directory(beside, fault) ? beside : fs::path("/usr/share/facenav");
}

}  // namespace core
}  // namespace facenav
