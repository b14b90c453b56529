#include "facenav/core/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>

#include "durable.h"
#include "facenav/core/error.h"
#include "facenav/core/standard_output.h"

namespace facenav {
inline namespace core {
namespace fs = std::filesystem;
namespace {

void makeEmptyPrivate(const fs::path& temporary, const fs::path& path) {
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (descriptor < 0) refuseWriting(path);
  ::close(descriptor);
}

/// The file that is written, behind links; for standard output a file that passes through it.
fs::path placeOfFile(const fs::path& path) {
  if (isStandardOutput(path)) return fs::temp_directory_path() / "output";
  const fs::path place = placeOf(path);
  if (fs::is_directory(place))
    throw Error("is a folder, a file is written here", path.string(), "choose another place");
  return place;
}

}  // namespace

WholeFile::WholeFile(fs::path path, FileAccess access)
    : path_(std::move(path)),
      place_(placeOfFile(path_)),
      temporary_(temporaryBeside(place_)),
      access_(isStandardOutput(path_) ? FileAccess::owner_only : access) {
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
  if (isStandardOutput(path_)) return copyToStandardOutput(temporary_);  // the destructor removes it
  // A writer may have created a new file under this name.
  if (access_ == FileAccess::owner_only) setMode(temporary_, 0600);
  syncFile(temporary_);
  std::error_code error;
  fs::rename(temporary_, place_, error);
  if (error)
    throw Error("cannot be written (" + error.message() + ")", path_.string(), "choose another place");
  is_committed_ = true;
  syncNamesIn(parentOf(place_));
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
