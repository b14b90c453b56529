#include "file_prefix.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "facenav/core/error.h"

namespace facenav::dicom {
namespace {

/// Returns the number of bytes read: fewer than `length` at the file's end or on failure.
std::uint64_t readAt(int file, std::uint64_t offset, std::uint64_t length, char* to) {
  std::uint64_t have = 0;
  while (have < length) {
    const ssize_t got = ::pread(file, to + have, length - have, off_t(offset + have));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    have += std::uint64_t(got);
  }
  return have;
}

}  // namespace

FilePrefix::FilePrefix(std::filesystem::path path)
    : path_(std::move(path)), file_(::open(path_.c_str(), O_RDONLY | O_CLOEXEC)) {
  struct stat status {};
  const bool is_readable = file_ >= 0 && ::fstat(file_, &status) == 0 && S_ISREG(status.st_mode);
  if (!is_readable) {
    close();
    throw Error("cannot be read", path_.string(), "check that it exists and its permissions");
  }
  size_ = std::uint64_t(status.st_size);
}

FilePrefix::FilePrefix(std::filesystem::path path, std::string content)
    : path_(std::move(path)), size_(content.size()), bytes_(std::move(content)) {}

FilePrefix::~FilePrefix() { close(); }

void FilePrefix::close() {
  if (file_ >= 0) ::close(file_);
  file_ = -1;
}

bool FilePrefix::ensure(std::uint64_t end) {
  constexpr std::uint64_t kFirstRead = 16 << 10;
  if (end <= bytes_.size()) return true;
  if (end > size_ || file_ < 0) return false;
  const std::uint64_t have = bytes_.size();
  const std::uint64_t want = std::min(size_, std::max({end, kFirstRead, have + have / 2}));
  bytes_.resize(want);
  bytes_.resize(have + readAt(file_, have, want - have, bytes_.data() + have));
  return end <= bytes_.size();
}

bool FilePrefix::copy(std::uint64_t offset, std::uint64_t length, char* to) const {
  if (offset > size_ || length > size_ - offset) return false;
  const std::uint64_t begin = std::min<std::uint64_t>(offset, bytes_.size());
  const std::uint64_t known = std::min<std::uint64_t>(bytes_.size() - begin, length);
  std::memcpy(to, bytes_.data() + begin, known);
  if (known == length) return true;
  return file_ >= 0 && readAt(file_, offset + known, length - known, to + known) == length - known;
}

void FilePrefix::replace(std::string content) {
  close();
  size_ = content.size();
  bytes_ = std::move(content);
}

}  // namespace facenav::dicom
