#include "appended_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "facenav/core/error.h"

namespace facenav::casefile {
namespace {

/// 0, or the errno of the failed call.
int writeAll(int descriptor, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = ::write(descriptor, text.data() + done, text.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    done += std::size_t(written);
  }
  return 0;
}

}  // namespace

AppendedFile::AppendedFile(std::filesystem::path path, const std::string& header, Start start)
    : path_(std::move(path)) {
  const int exclusive = start == Start::fresh ? O_EXCL : 0;
  descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | exclusive | O_APPEND | O_CLOEXEC, 0600);
  if (descriptor_ < 0) refuse(std::strerror(errno));
  size_ = size_before_ = ::lseek(descriptor_, 0, SEEK_END);
  if (size_ > 0) {  // a line cut short by a power cut must not join the next one
    char last = '\n';
    if (::pread(descriptor_, &last, 1, size_ - 1) == 1 && last != '\n') append("\n");
  } else if (!header.empty()) {
    append(header);
  }
}

AppendedFile::~AppendedFile() {
  ::fsync(descriptor_);
  ::close(descriptor_);
}

void AppendedFile::append(const std::string& lines) {
  if (isRemoved()) refuse("it was removed");
  const int fault = writeAll(descriptor_, lines);
  if (fault != 0) {
    if (::ftruncate(descriptor_, size_) != 0) size_ = ::lseek(descriptor_, 0, SEEK_END);
    refuse(std::strerror(fault));
  }
  size_before_ = size_;
  size_ += (long long)lines.size();
}

void AppendedFile::sync() {
  if (::fsync(descriptor_) != 0) refuse(std::strerror(errno));
}

void AppendedFile::lock() {
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0)
    throw Error("another program writes this session", path_.parent_path().string(), "end it there first");
}

bool AppendedFile::isRemoved() const {
  struct stat status {};
  return ::fstat(descriptor_, &status) == 0 && status.st_nlink == 0;
}

std::string AppendedFile::content() const {
  std::string text(std::size_t(size_), '\0');
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t got = ::pread(descriptor_, text.data() + done, text.size() - done, off_t(done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) refuse(std::strerror(errno));
    if (got == 0) text.resize(done);
    done += std::size_t(got);
  }
  return text;
}

void AppendedFile::undoLast() {
  if (::ftruncate(descriptor_, size_before_) == 0) size_ = size_before_;
}

void AppendedFile::refuse(const std::string& why) const {
  throw Error("cannot be written (" + why + ")", path_.string(), "check free disk space and permissions");
}

bool isLocked(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool is_free = ::flock(descriptor, LOCK_SH | LOCK_NB) == 0;
  ::close(descriptor);
  return !is_free;
}

}  // namespace facenav::casefile
