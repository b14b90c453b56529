#pragma once
// facenav sessions CASE --compare A B.

#include <filesystem>
#include <string>

namespace facenav::app {

/// Prints the return error of the coil in `second` against `first`. Throws Error.
void compareSessions(const std::filesystem::path& case_folder, const std::string& first,
                     const std::string& second, bool is_json);

}  // namespace facenav::app
