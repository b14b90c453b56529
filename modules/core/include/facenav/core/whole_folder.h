#pragma once
// WholeFolder: a folder that appears whole or not at all. Fill temporaryPath() (a hidden folder beside the
// place), then commit(): sync, one rename. A crash leaves the old folder or the new one, never a mixture. A
// WholeFolder destroyed without commit() removes what was written.

#include <filesystem>

#include "facenav/core/file_access.h"

namespace facenav {
inline namespace core {

/// What may lie at the place already: nothing or an empty folder, or anything (which commit() replaces and
/// removes).
enum class Existing { refuse, replace };

class WholeFolder {
 public:
  /// Throws Error if the parent folder does not exist or cannot be written to, or if `folder` holds something
  /// and `existing` is refuse. With owner_only the temporary folder is 0700 from the start, so that nobody
  /// else reaches what is written in it.
  explicit WholeFolder(const std::filesystem::path& folder, FileAccess access = FileAccess::by_umask,
                       Existing existing = Existing::refuse);
  ~WholeFolder();
  WholeFolder(const WholeFolder&) = delete;
  WholeFolder& operator=(const WholeFolder&) = delete;

  const std::filesystem::path& temporaryPath() const { return temporary_; }
  /// Makes all files durable and the folder visible under its name; with owner_only every file inside becomes
  /// 0600, every folder 0700 (links are left alone). Throws Error (disk full, no permission, place taken in
  /// the meantime); the old folder stands then.
  void commit();

 private:
  std::filesystem::path folder_, temporary_;
  FileAccess access_;
  Existing existing_;
  bool is_committed_ = false;
};

/// Makes a folder of mode 0700. Throws Error where it exists or cannot be made.
void makePrivateFolder(const std::filesystem::path& folder);
/// Sets 0600 on files and 0700 on folders, recursively (links are left alone), and forces all to the disk.
/// Throws Error.
void makePrivateAndDurable(const std::filesystem::path& folder);
/// The names in a folder outlast a power failure. Throws Error.
void makeNamesDurable(const std::filesystem::path& folder);

}  // namespace core
}  // namespace facenav
