#pragma once
// WholeFile: a file that is written completely or not at all. Write to temporaryPath() (same folder, same
// extension), then call commit(): fsync, rename, fsync of the folder, so that the file survives a power cut.
// Without commit(), the destructor removes the temporary file. A link is followed, and the path "-" is
// standard output; a device or a pipe is never replaced. For folders see core/whole_folder.h.

#include <filesystem>
#include <string>

#include "facenav/core/file_access.h"

namespace facenav {
inline namespace core {

class WholeFile {
 public:
  /// If owner_only, creates the temporary file here, empty, with mode 0600; a writer that opens it by name
  /// keeps that mode. Throws Error if the folder of `path` does not exist or cannot be written to, or if
  /// `path` is no regular file.
  explicit WholeFile(std::filesystem::path path, FileAccess access = FileAccess::owner_only);
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  const std::filesystem::path& temporaryPath() const { return temporary_; }
  /// Makes the file durable and visible under its name. Throws Error if nothing was written (an empty file
  /// with owner_only), the disk is full or permission is missing.
  void commit();

 private:
  friend void writeWholeFile(const std::filesystem::path&, const std::string&, FileAccess);
  void publish();

  std::filesystem::path path_, place_, temporary_;  // as given, and behind links
  FileAccess access_;
  bool is_committed_ = false;
};

/// Writes `content` as a whole file. Throws Error.
void writeWholeFile(const std::filesystem::path& path, const std::string& content,
                    FileAccess access = FileAccess::owner_only);
/// The whole content of a file. Throws Error if it is missing or unreadable.
std::string readWholeFile(const std::filesystem::path& path);

}  // namespace core
}  // namespace facenav
