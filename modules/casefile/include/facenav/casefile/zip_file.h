#pragma once
// One file that holds several (ZIP, stored, PKWARE's APPNOTE.TXT 4.3): what goes home with a patient, and
// what comes back. Any program opens it. Read back, each entry's checksum is verified.

#include <filesystem>
#include <map>
#include <string>

#include "facenav/core/file_access.h"

namespace facenav::casefile {

/// Content by name; names are relative, with '/' between folders. Writes the whole file or nothing. Throws
/// Error, also where all together are 2 GiB or more.
void writeZip(const std::map<std::string, std::string>& entries, const std::filesystem::path& path,
              FileAccess access);
/// Throws Error: no such file, cut short or damaged, packed by another program with compression, or a name
/// that leads out of the folder that it is unpacked into.
std::map<std::string, std::string> readZip(const std::filesystem::path& path);

}  // namespace facenav::casefile
