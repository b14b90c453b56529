#pragma once
// SHA-256 (OpenSSL's libcrypto) of a step's input, for the provenance in case.json.

#include <filesystem>
#include <string>

namespace facenav::casefile {

/// Lower-case hex of a file's content. Throws Error when it cannot be read.
std::string sha256OfFile(const std::filesystem::path& path);
std::string sha256OfText(const std::string& text);
/// A file's hash. For a folder: the hash of the sorted hashes of all its files, so that it does not depend on
/// names (which may be a patient's) or order.
std::string sha256OfInput(const std::filesystem::path& path);

}  // namespace facenav::casefile
