#pragma once
// SHA-256 (OpenSSL's libcrypto) of what a step was given, for the provenance in case.json.

#include <filesystem>
#include <string>

namespace facenav::casefile {

/// Lower-case hex of a file's content. Throws Error when it cannot be read.
std::string sha256OfFile(const std::filesystem::path& path);
/// A file's hash; or, for a folder, the hash over the sorted hashes of all files in it, so that names (which
/// may hold a patient's) and order do not enter.
std::string sha256OfInput(const std::filesystem::path& path);

}  // namespace facenav::casefile
