#pragma once
// FileSet: the files of a folder or an archive under their names in it, with '/' between folders, for formats
// that need several files. Contents are read when asked for.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace facenav::interop {

class FileSet {
 public:
  /// The whole folder with its subfolders (hidden ones left out), or the archive. Throws Error: unreadable,
  /// or more than 100000 files.
  explicit FileSet(const std::filesystem::path& root);
  /// Files in memory; `root` names them in messages.
  FileSet(std::map<std::string, std::string> contents, const std::filesystem::path& root);
  /// The files that lie in `folder` and in the folders between it and `root`; `is_deep`: also those in its
  /// subfolders. Names are relative to `root`. Throws Error as the whole folder does.
  static FileSet below(const std::filesystem::path& root, const std::filesystem::path& folder, bool is_deep);

  const std::filesystem::path& root() const { return root_; }
  const std::vector<std::string>& names() const { return names_; }  // sorted
  bool has(const std::string& name) const;
  /// Content without a byte order mark, and with '\n' for the line ends of old Macs. Throws Error: no such
  /// file, or larger than the largest list of targets.
  std::string read(const std::string& name) const;
  /// The file's place for messages.
  std::filesystem::path path(const std::string& name) const { return root_ / name; }
  /// The file on the disk; nothing in an archive, or if it is not there or would lie outside of the folder.
  std::optional<std::filesystem::path> onDisk(const std::string& name) const;

 private:
  FileSet() = default;
  void addFolder(const std::filesystem::path& folder, bool is_deep);
  std::filesystem::path root_;
  std::vector<std::string> names_;
  std::map<std::string, std::string> archived_;  // name as stored in the archive, by name
  std::optional<std::map<std::string, std::string>> in_memory_;
};

/// The text without a byte order mark, with the line ends of old Macs made '\n'.
std::string plainText(std::string content);
/// Parts of a name, "sub-01/nibs/x.tsv": the folder with its '/' ("" for none), and the last part.
std::string folderOf(const std::string& name);
std::string lastOf(const std::string& name);
bool endsWith(const std::string& text, const std::string& end);

}  // namespace facenav::interop
