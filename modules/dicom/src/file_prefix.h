#pragma once
// The first bytes of a file, read as far as asked for: headers are read without touching the pixels behind
// them.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace facenav::dicom {

class FilePrefix {
 public:
  /// Throws Error when the file cannot be opened or its size is unknown.
  explicit FilePrefix(std::filesystem::path path);
  /// Bytes already in memory stand for the file (inflated data, tests, the fuzzer).
  FilePrefix(std::filesystem::path path, std::string content);

  const std::filesystem::path& path() const { return path_; }
  std::uint64_t fileSize() const { return size_; }
  /// Reads on until `end` bytes lie in bytes(); false when the file is shorter.
  bool ensure(std::uint64_t end);
  const std::string& bytes() const { return bytes_; }
  /// From here on `content` stands for the file.
  void replace(std::string content);

 private:
  std::filesystem::path path_;
  std::ifstream stream_;
  std::uint64_t size_ = 0;
  std::string bytes_;
};

}  // namespace facenav::dicom
