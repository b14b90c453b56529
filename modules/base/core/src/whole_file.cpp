#include "facenav/core/whole_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>

#include "durable.h"
#include "facenav/core/error.h"

namespace facenav {
inline namespace core {
namespace fs = std::filesystem;
namespace {

void makeEmptyPrivate(const fs::path& temporary, const fs::path& path) {
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (descriptor < 0) refuseWriting(path);
  ::close(descriptor);
}

}  // namespace

WholeFile::WholeFile(fs::path path, FileAccess access)
    : path_(std::move(path)), temporary_(temporaryBeside(path_)), access_(access) {
  if (access_ == FileAccess::owner_only) makeEmptyPrivate(temporary_, path_);
}

WholeFile::~WholeFile() {
  if (is_committed_) return;
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void WholeFile::commit() {
  const bool is_written =
      fs::exists(temporary_) && (access_ == FileAccess::by_umask || !fs::is_empty(temporary_));
  if (!is_written) throw Error("could not be written", path_.string(), "check free disk space");
  publish();
}

void WholeFile::publish() {
  // A writer may have created a new file under this name.
  if (access_ == FileAccess::owner_only && ::chmod(temporary_.c_str(), 0600) != 0) refuseWriting(path_);
  syncFile(temporary_);
  std::error_code error;
  fs::rename(temporary_, path_, error);
  if (error)
    throw Error("cannot be written (" + error.message() + ")", path_.string(), "choose another place");
  is_committed_ = true;
  syncNamesIn(parentOf(path_));
}

void writeWholeFile(const fs::path& path, const std::string& content, FileAccess access) {
  WholeFile file(path, access);
  {
    std::ofstream stream(file.temporaryPath(), std::ios::binary);
    stream << content;
    stream.flush();
    if (!stream) throw Error("cannot be written", path.string(), "check free disk space and permissions");
  }
  file.publish();
}

std::string readWholeFile(const fs::path& path) {
  if (!fs::exists(path)) throw Error("file does not exist", path.string(), "check the path");
  if (fs::is_directory(path)) throw Error("is a folder, a file was expected", path.string());
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw Error("cannot be read", path.string(), "check its permissions");
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace core
}  // namespace facenav
