#pragma once
// Files for the user alone: 0600, folders 0700; folders swapped whole.

#include <filesystem>
#include <string>

namespace facenav::casefile {

/// A file, or the names in a folder, outlast a power failure. Throws Error.
void forceToDisk(const std::filesystem::path& path);
/// Creates a folder with mode 0700. Throws Error.
void makePrivateFolder(const std::filesystem::path& folder);
/// Sets 0600 on files and 0700 on folders, recursively, and forces everything to the disk. Throws Error.
void makePrivateAndDurable(const std::filesystem::path& folder);
/// Writes a whole file of mode 0600. Throws Error.
void writePrivateFile(const std::filesystem::path& path, const std::string& content);
/// Puts `fresh` in the place of `folder`, which may exist; what was there is removed. A crash leaves either
/// the old or the new folder whole. Throws Error.
void replaceFolder(const std::filesystem::path& fresh, const std::filesystem::path& folder);

/// A folder beside `folder` under a temporary name, removed unless it was put in place.
class TemporarySibling {
 public:
  explicit TemporarySibling(const std::filesystem::path& folder);
  ~TemporarySibling();
  TemporarySibling(const TemporarySibling&) = delete;
  TemporarySibling& operator=(const TemporarySibling&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Now, as 20100412T134501Z.
std::string utcNow();

}  // namespace facenav::casefile
