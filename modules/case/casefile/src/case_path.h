#pragma once
// The path of a case folder, and whether there is a case.

#include <filesystem>

namespace facenav::casefile {

/// Absolute, without a slash at the end.
inline std::filesystem::path cleaned(const std::filesystem::path& folder) {
  std::filesystem::path path = std::filesystem::absolute(folder).lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

inline bool isCase(const std::filesystem::path& folder) {
  return std::filesystem::is_regular_file(folder / "case.json");
}

}  // namespace facenav::casefile
