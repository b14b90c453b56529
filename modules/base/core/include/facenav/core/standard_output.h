#pragma once
// Standard output as the place of a file: `-o -`. WholeFile writes to it; what a verb prints then goes to
// standard error, so that the two do not mix.

#include <filesystem>
#include <string>

namespace facenav {
inline namespace core {

/// Returns true for the path "-".
bool isStandardOutput(const std::filesystem::path& path);
/// Turns everything that is printed from now on to standard error; files written to "-" keep standard output.
void keepStandardOutputForFiles();
/// Writes the content of a file to standard output. Throws Error if the reader has gone.
void copyToStandardOutput(const std::filesystem::path& file);

}  // namespace core
}  // namespace facenav
