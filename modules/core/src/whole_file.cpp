#include "facenav/core/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "facenav/core/error.h"

namespace facenav {
inline namespace core {
namespace fs = std::filesystem;
namespace {

void syncToDisk(const fs::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY);
  if (descriptor < 0 || ::fsync(descriptor) != 0) {
    const std::string reason = std::strerror(errno);
    if (descriptor >= 0) ::close(descriptor);
    throw Error("cannot be written (" + reason + ")", path.string(), "check free disk space and permissions");
  }
  ::close(descriptor);
}

}  // namespace

WholeFile::WholeFile(fs::path path) : path_(std::move(path)) {
  static std::atomic<int> counter{0};
  const fs::path folder = path_.has_parent_path() ? path_.parent_path() : fs::path(".");
  if (!fs::is_directory(folder)) throw Error("folder does not exist", folder.string(), "create it first");
  if (::access(folder.c_str(), W_OK) != 0)
    throw Error("folder is not writable", folder.string(), "choose another");
  const std::string name = path_.filename().string();
  // The temporary name keeps everything after the first dot, since writers choose the format by extension.
  temporary_ = folder / (".tmp" + std::to_string(::getpid()) + "_" + std::to_string(counter++) + "_" + name);
}

WholeFile::~WholeFile() {
  if (is_committed_) return;
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void WholeFile::commit() {
  if (!fs::exists(temporary_)) throw Error("could not be written", path_.string(), "check free disk space");
  syncToDisk(temporary_);
  std::error_code error;
  fs::rename(temporary_, path_, error);
  if (error)
    throw Error("cannot be written (" + error.message() + ")", path_.string(), "choose another place");
  is_committed_ = true;
}

void writeWholeFile(const fs::path& path, const std::string& content) {
  WholeFile file(path);
  {
    std::ofstream stream(file.temporaryPath(), std::ios::binary);
    stream << content;
    stream.flush();
    if (!stream) throw Error("cannot be written", path.string(), "check free disk space and permissions");
  }
  file.commit();
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
