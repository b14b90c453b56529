#pragma once
// FileGroup: files and folders that belong together, such as an alignment and the photographs that it rests
// on. They are written into a private folder beside their places and then moved there: either every one is
// replaced, or none.

#include <filesystem>
#include <string>
#include <vector>

namespace facenav::casefile {

class FileGroup {
 public:
  /// Makes the private folder (0700) inside `folder`. Throws Error where that cannot be done.
  explicit FileGroup(std::filesystem::path folder);
  /// Removes what was not committed.
  ~FileGroup();
  FileGroup(const FileGroup&) = delete;
  FileGroup& operator=(const FileGroup&) = delete;

  /// Files and folders are written here, under their final names.
  const std::filesystem::path& staging() const { return fresh_; }
  /// Sets 0600 on files and 0700 on folders, forces them to the disk and moves each into its place. `key` is
  /// the file without which the others do not count: it goes first and comes last, so that a crash in between
  /// leaves no mixture of old and new. Throws Error where one cannot be replaced (also a file by a folder);
  /// then all are as before.
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
  bool keeps_old_ = false;  // they could not be moved back
};

}  // namespace facenav::casefile
