#pragma once
// WholeFolder: a folder that is written completely or not at all. Fill temporaryPath() (a hidden folder
// beside the destination), then call commit(): sync and one rename. After a crash either the old or the new
// folder exists, never a mixture. Without commit(), the destructor removes what was written.

#include <filesystem>

#include "facenav/core/file_access.h"

namespace facenav {
inline namespace core {

/// Existing content allowed at the destination. refuse: nothing or an empty folder. replace: anything;
/// commit() replaces and removes it.
enum class Existing { refuse, replace };

class WholeFolder {
 public:
  /// Throws Error if the parent folder does not exist or cannot be written to, or if `folder` is not empty
  /// and `existing` is refuse, or if `folder` is a file or a device. A link is followed. With owner_only the
  /// temporary folder has mode 0700 from the start, so that no other user can reach its content.
  explicit WholeFolder(const std::filesystem::path& folder, FileAccess access = FileAccess::owner_only,
                       Existing existing = Existing::refuse);
  ~WholeFolder();
  WholeFolder(const WholeFolder&) = delete;
  WholeFolder& operator=(const WholeFolder&) = delete;

  const std::filesystem::path& temporaryPath() const { return temporary_; }
  /// Makes all files durable and the folder visible under its name. With owner_only every file inside gets
  /// mode 0600 and every folder 0700 (links are left alone). Throws Error (disk full, no permission,
  /// destination taken in the meantime); the old folder is then unchanged.
  void commit();

 private:
  std::filesystem::path folder_, temporary_;
  FileAccess access_;
  Existing existing_;
  bool is_committed_ = false;
};

/// Creates a folder of mode 0700. Throws Error if it exists or cannot be created.
void makePrivateFolder(const std::filesystem::path& folder);
/// Sets 0600 on files and 0700 on folders, recursively (links are left alone), and syncs all to the disk.
/// Throws Error.
void makePrivateAndDurable(const std::filesystem::path& folder);
/// Syncs the names in a folder, so that they survive a power cut. Throws Error.
void makeNamesDurable(const std::filesystem::path& folder);

}  // namespace core
}  // namespace facenav
