#pragma once
// The files of a case by name and size, without the names that a person or another program gave.

#include <filesystem>
#include <nlohmann/json.hpp>

namespace facenav::app {

/// Size in bytes of each file that lies in the folder itself; a folder: number of files and bytes below it.
nlohmann::ordered_json filesOfCase(const std::filesystem::path& folder);

}  // namespace facenav::app
