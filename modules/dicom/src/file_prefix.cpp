#include "file_prefix.h"

#include <algorithm>

#include "facenav/core/error.h"

namespace facenav::dicom {

FilePrefix::FilePrefix(std::filesystem::path path)
    : path_(std::move(path)), stream_(path_, std::ios::binary) {
  std::error_code error;
  size_ = std::filesystem::file_size(path_, error);
  if (!stream_ || error)
    throw Error("cannot be read", path_.string(), "check that it exists and its permissions");
}

FilePrefix::FilePrefix(std::filesystem::path path, std::string content)
    : path_(std::move(path)), size_(content.size()), bytes_(std::move(content)) {}

bool FilePrefix::ensure(std::uint64_t end) {
  constexpr std::uint64_t kFirstRead = 16 << 10;
  if (end <= bytes_.size()) return true;
  if (end > size_) return false;
  const std::uint64_t have = bytes_.size();
  const std::uint64_t want = std::min(size_, std::max({end, kFirstRead, have + have / 2}));
  bytes_.resize(want);
  stream_.read(bytes_.data() + have, std::streamsize(want - have));
  bytes_.resize(have + std::uint64_t(std::max<std::streamsize>(0, stream_.gcount())));
  return end <= bytes_.size();
}

void FilePrefix::replace(std::string content) {
  stream_.close();
  size_ = content.size();
  bytes_ = std::move(content);
}

}  // namespace facenav::dicom
