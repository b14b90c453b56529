#pragma once
// WholeFile: a file that appears whole or not at all. Write to temporaryPath() (same folder, same extension),
// then commit(): fsync, rename. A WholeFile destroyed without commit() removes its temporary file.

#include <filesystem>
#include <string>

namespace facenav {
inline namespace core {

class WholeFile {
 public:
  /// Throws Error if the folder of `path` does not exist or cannot be written to.
  explicit WholeFile(std::filesystem::path path);
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  const std::filesystem::path& temporaryPath() const { return temporary_; }
  /// Makes the file durable and visible under its name. Throws Error (disk full, no permission).
  void commit();

 private:
  std::filesystem::path path_, temporary_;
  bool is_committed_ = false;
};

/// Writes `content` as a whole file. Throws Error.
void writeWholeFile(const std::filesystem::path& path, const std::string& content);
/// The whole content of a file. Throws Error when it is missing or unreadable.
std::string readWholeFile(const std::filesystem::path& path);

}  // namespace core
}  // namespace facenav
