#pragma once
// Reads and writes ZIP archives: tracts of other programs (.trx), files that go home with a patient, and
// files that come back. libzip reads and writes it; every entry's checksum is verified. The callers
// (casefile, surface) define the entries.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "facenav/core/file_access.h"

namespace facenav {
inline namespace core {

/// Content of each file by its name, with '/' between folders.
using ZipEntries = std::map<std::string, std::string>;

/// Throws Error: no such file, no ZIP archive, cut short, damaged, encrypted, an entry of over 8 GiB, or a
/// name that leads out of the folder that it is unpacked into.
ZipEntries readZip(const std::filesystem::path& path);

/// Names of the files in the archive, without its folders. Throws Error as readZip() does.
std::vector<std::string> zipNames(const std::filesystem::path& path);
/// Content of one file of the archive. Throws Error as readZip() does, also for a name that is not there or a
/// file of over `most_bytes`.
std::string readZipEntry(const std::filesystem::path& path, const std::string& name, std::size_t most_bytes);

/// Writes the whole file or nothing; equal entries give equal bytes. Throws Error.
void writeZip(const ZipEntries& entries, const std::filesystem::path& path,
              FileAccess access = FileAccess::owner_only);

}  // namespace core
}  // namespace facenav
