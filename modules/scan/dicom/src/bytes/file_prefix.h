#pragma once
// The first bytes of a file, read on demand: headers are read without the pixels after them.

#include <cstdint>
#include <filesystem>
#include <string>

namespace facenav::dicom {

class FilePrefix {
 public:
  /// Throws Error when the file cannot be opened or its size is unknown.
  explicit FilePrefix(std::filesystem::path path);
  /// `content` replaces the file (inflated data, tests, the fuzzer).
  FilePrefix(std::filesystem::path path, std::string content);
  ~FilePrefix();
  FilePrefix(const FilePrefix&) = delete;
  FilePrefix& operator=(const FilePrefix&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::uint64_t fileSize() const { return size_; }
  /// Reads until bytes() has `end` bytes; false when the file is shorter.
  bool ensure(std::uint64_t end);
  const std::string& bytes() const { return bytes_; }
  /// Copies `length` bytes from `offset` to `to`, without keeping them; false when the file is shorter.
  bool copy(std::uint64_t offset, std::uint64_t length, char* to) const;
  /// Replaces the file by `content` from then on.
  void replace(std::string content);

 private:
  void close();
  std::filesystem::path path_;
  int file_ = -1;
  std::uint64_t size_ = 0;
  std::string bytes_;
};

}  // namespace facenav::dicom
