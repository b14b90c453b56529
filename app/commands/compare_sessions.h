#pragma once
// facenav sessions CASE --compare A B.

#include <filesystem>
#include <string>

namespace facenav::app {

/// Prints how far the coil of `second` came back to where it was in `first`. Throws Error.
void compareSessions(const std::filesystem::path& case_folder, const std::string& first,
                     const std::string& second, bool is_json);

}  // namespace facenav::app
