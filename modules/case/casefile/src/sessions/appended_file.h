#pragma once
// AppendedFile: a private file (0600) that grows line by line. A line that cannot be written whole (full
// disk) is cut off again, so the file always ends with a whole line while the program runs.

#include <filesystem>
#include <string>

namespace facenav::casefile {

class AppendedFile {
 public:
  enum class Start { fresh, old_or_fresh };
  /// Opens the file. `fresh` throws Error if it exists. A fresh file starts with `header` (empty: nothing).
  AppendedFile(std::filesystem::path path, const std::string& header, Start start = Start::fresh);
  /// Syncs and closes.
  ~AppendedFile();
  AppendedFile(const AppendedFile&) = delete;
  AppendedFile& operator=(const AppendedFile&) = delete;

  /// Appends `lines`, with their newlines, whole or not at all. Throws Error, also if the file was removed
  /// meanwhile.
  void append(const std::string& lines);
  /// Calls fsync. Throws Error.
  void sync();
  /// Locks the file for other programs until this one has closed it or ended. Throws Error if another program
  /// has the lock.
  void lock();
  /// True if the file was removed, so that its content can no longer be found by name.
  bool isRemoved() const;
  /// Makes a removed file again under its name with all its content, and the two folders above it if need be.
  /// Throws Error; nothing has then changed.
  void putBack();
  /// Cuts the file back to its state before the last append, for a line that was written but not synced.
  void undoLast();

 private:
  [[noreturn]] void refuse(const std::string& why) const;
  int copied() const;
  std::filesystem::path path_;
  int descriptor_ = -1;
  bool is_locked_ = false;
  long long size_ = 0, size_before_ = 0;  // bytes of whole lines
};

/// True if another program has the file's lock(). False if there is no such file.
bool isLocked(const std::filesystem::path& path);

}  // namespace facenav::casefile
