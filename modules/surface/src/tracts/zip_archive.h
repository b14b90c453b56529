#pragma once
// The entries of a ZIP archive, stored or deflated, also with 64-bit sizes (PKWARE's APPNOTE.TXT, sections
// 4.3 and 4.5). Private to surface.

#include <filesystem>
#include <map>
#include <string>

namespace facenav::surface {

/// Content of each file by its name. `path` names the archive in errors. Throws Error for a damaged one.
std::map<std::string, std::string> readZip(const std::string& bytes, const std::filesystem::path& path);

}  // namespace facenav::surface
