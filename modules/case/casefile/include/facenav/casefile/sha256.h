#pragma once
// SHA-256 (OpenSSL's libcrypto) of a step's input, for the provenance in case.json.

#include <filesystem>
#include <string>

namespace facenav::casefile {

/// Computes the hash of a file's content in lower-case hex. Throws Error when it cannot be read.
std::string sha256OfFile(const std::filesystem::path& path);
std::string sha256OfText(const std::string& text);
/// Computes the hash of a file or folder. A folder's hash is that of the sorted hashes of all its files, so
/// it does not depend on their order or names (which may be a patient's).
std::string sha256OfInput(const std::filesystem::path& path);

}  // namespace facenav::casefile
