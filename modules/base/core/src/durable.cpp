#include "durable.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <vector>

#include "facenav/core/error.h"

namespace facenav {
inline namespace core {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kManyFiles = 64;

/// 0, or the errno of the failed call.
int faultOfSync(const fs::path& path, int (*sync)(int)) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return errno;
  const int fault = sync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  return fault;
}

void requireSynced(const fs::path& path, int (*sync)(int)) {
  errno = faultOfSync(path, sync);
  if (errno != 0) refuseWriting(path);
}

}  // namespace

fs::path parentOf(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

fs::path temporaryBeside(const fs::path& path) {
  static std::atomic<int> counter{0};
  const fs::path folder = parentOf(path);
  if (!fs::is_directory(folder)) throw Error("folder does not exist", folder.string(), "create it first");
  if (::access(folder.c_str(), W_OK) != 0)
    throw Error("folder is not writable", folder.string(), "choose another");
  return folder / (".tmp" + std::to_string(::getpid()) + "_" + std::to_string(counter++) + "_" +
                   path.filename().string());
}

fs::path placeOf(const fs::path& path) {
  const auto refuse = [&](const std::string& what) {
    throw Error(what, path.string(), "choose another place ('-o -' writes a file to standard output)");
  };
  std::error_code fault;
  fs::path place = path;
  if (fs::is_symlink(fs::symlink_status(path, fault))) {
    place = fs::canonical(path, fault);
    if (fault) refuse("is a link that leads nowhere");
  }
  const auto status = fs::status(place, fault);
  if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status))
    refuse("is neither a file nor a folder, and is not replaced");
  for (const auto& each : {path, place}) {
    const std::string whole = fs::absolute(each, fault).lexically_normal().string();
    const auto isIn = [&](const char* folder) { return whole.rfind(folder, 0) == 0; };
    if ((isIn("/dev/") && !isIn("/dev/shm/")) || isIn("/proc/") || isIn("/sys/"))
      refuse("belongs to the system, and is not replaced");
  }
  return place;
}

void setMode(const fs::path& path, unsigned mode) {
  if (::chmod(path.c_str(), mode_t(mode)) == 0 || errno == EPERM || errno == ENOTSUP) return;
  refuseWriting(path);
}

void refuseWriting(const fs::path& path) {
  throw Error(std::string("cannot be written (") + std::strerror(errno) + ")", path.string(),
              "check free disk space and permissions");
}

void syncFile(const fs::path& path) { requireSynced(path, ::fsync); }

void syncNamesIn(const fs::path& folder) {
  errno = faultOfSync(folder, ::fsync);
  if (errno == EIO || errno == ENOSPC || errno == EDQUOT) refuseWriting(folder);
}

void syncAllIn(const fs::path& folder) {
  std::vector<fs::path> all{folder};
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (!entry.is_symlink()) all.push_back(entry.path());
  if (all.size() > kManyFiles) return requireSynced(folder, ::syncfs);
  for (const auto& path : all) syncFile(path);
}

}  // namespace core
}  // namespace facenav
