#include "appended_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "facenav/core/error.h"
#include "facenav/core/whole_folder.h"

namespace facenav::casefile {
namespace {

/// Writes the text; returns 0 or the errno of the failed call.
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
  is_locked_ = true;
}

bool AppendedFile::isRemoved() const {
  struct stat status {};
  return ::fstat(descriptor_, &status) == 0 && status.st_nlink == 0;
}

/// Copies the removed file's content to a new file under its name and syncs it.
int AppendedFile::copied() const {
  const auto temporary = path_.string() + ".again";
  const int copy = ::open(temporary.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0600);
  if (copy < 0) refuse(std::strerror(errno));
  int fault = 0;
  std::string block(1 << 20, '\0');
  for (long long done = 0; done < size_ && fault == 0;) {
    const auto wanted = std::size_t(std::min<long long>(size_ - done, (long long)block.size()));
    const ssize_t got = ::pread(descriptor_, block.data(), wanted, off_t(done));
    if (got < 0 && errno == EINTR) continue;
    fault = got < 0 ? errno : got == 0 ? EIO : writeAll(copy, block.substr(0, std::size_t(got)));
    done += got;
  }
  if (fault == 0 && ::fsync(copy) != 0) fault = errno;
  if (fault == 0 && ::link(temporary.c_str(), path_.c_str()) != 0) fault = errno;  // never over another file
  ::unlink(temporary.c_str());
  if (fault == 0) return copy;
  ::close(copy);
  refuse(std::strerror(fault));
}

void AppendedFile::putBack() {
  if (!isRemoved()) return;
  const auto folder = path_.parent_path();
  for (const auto& missing : {folder.parent_path(), folder})
    if (!std::filesystem::exists(missing)) makePrivateFolder(missing);
  const int copy = copied();
  ::close(std::exchange(descriptor_, copy));
  if (is_locked_) lock();
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
