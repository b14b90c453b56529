#pragma once
// FileGroup: files and folders that belong together, such as an alignment and its photographs. They are
// written into a private folder beside their final places and then moved there: all are replaced, or none. A
// program that is killed in between leaves that folder behind; removeAbandonedGroups() removes it later.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace facenav::casefile {

class GroupLock;

class FileGroup {
 public:
  /// Makes the private folder (0700) inside `folder`, and removes those that killed programs left there.
  /// Throws Error if it cannot be made.
  explicit FileGroup(std::filesystem::path folder);
  /// Removes what was not committed.
  ~FileGroup();
  FileGroup(const FileGroup&) = delete;
  FileGroup& operator=(const FileGroup&) = delete;

  /// Private folder to write files and folders into, under their final names.
  const std::filesystem::path& staging() const { return fresh_; }
  /// Sets 0600 on files and 0700 on folders, syncs them to the disk and moves each into its place. Readers
  /// ignore the others while the file `key` is missing: its old version is removed first and its new one is
  /// placed last, so a crash in between leaves no mixture of old and new. Throws Error if one cannot be
  /// replaced (also a file by a folder); then nothing has changed.
  void commit(const std::string& key);

 private:
  struct Move {
    std::filesystem::path from, to;
  };
  void move(const std::filesystem::path& from, const std::filesystem::path& to);
  void setAside(const std::string& name);
  void putInPlace(const std::string& name);
  void undo();

  std::filesystem::path folder_, root_, fresh_, old_;
  std::vector<Move> moves_;
  bool keeps_old_ = false;  // set if moving them back failed
  std::unique_ptr<GroupLock> lock_;
};

/// Removes the private folders that killed programs left in `folder`. Never removes one whose program may
/// still run, on this machine or on another that shares the folder, nor the only copy of a file (an alignment
/// that was being replaced). Ignores folders that cannot be removed.
void removeAbandonedGroups(const std::filesystem::path& folder);

}  // namespace facenav::casefile
