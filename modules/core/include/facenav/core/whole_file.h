#pragma once
// WholeFile: a file that appears whole or not at all. Write to temporaryPath() (same folder, same extension),
// then commit(): fsync, rename, fsync of the folder, so that it survives a power cut. A WholeFile destroyed
// without commit() removes its temporary file. Whole folders: core/whole_folder.h.

#include <filesystem>
#include <string>

#include "facenav/core/file_access.h"

namespace facenav {
inline namespace core {

class WholeFile {
 public:
  /// With owner_only, the temporary file is made here, empty, with mode 0600: a writer that opens it by name
  /// keeps that mode. Throws Error if the folder of `path` does not exist or cannot be written to.
  explicit WholeFile(std::filesystem::path path, FileAccess access = FileAccess::by_umask);
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  const std::filesystem::path& temporaryPath() const { return temporary_; }
  /// Makes the file durable and visible under its name. Throws Error where nothing was written (an empty file
  /// with owner_only), the disk is full or the place is not allowed.
  void commit();

 private:
  friend void writeWholeFile(const std::filesystem::path&, const std::string&, FileAccess);
  void publish();

  std::filesystem::path path_, temporary_;
  FileAccess access_;
  bool is_committed_ = false;
};

/// Writes `content` as a whole file. Throws Error.
void writeWholeFile(const std::filesystem::path& path, const std::string& content,
                    FileAccess access = FileAccess::by_umask);
/// The whole content of a file. Throws Error when it is missing or unreadable.
std::string readWholeFile(const std::filesystem::path& path);

}  // namespace core
}  // namespace facenav
