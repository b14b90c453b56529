#include "private_files.h"

#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <ctime>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"

namespace facenav::casefile {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void refuse(const fs::path& path) {
  throw Error(std::string("cannot be written (") + std::strerror(errno) + ")", path.string(),
              "check free disk space and permissions");
}

fs::path parentOf(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

}  // namespace

void forceToDisk(const fs::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY);
  if (descriptor < 0) refuse(path);
  const int status = ::fsync(descriptor);
  ::close(descriptor);
  if (status != 0) refuse(path);
}

void makePrivateFolder(const fs::path& folder) {
  if (::mkdir(folder.c_str(), 0700) != 0) refuse(folder);
}

void makePrivateAndDurable(const fs::path& folder) {
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_symlink()) continue;
    if (::chmod(entry.path().c_str(), entry.is_directory() ? 0700 : 0600) != 0) refuse(entry.path());
    forceToDisk(entry.path());
  }
  if (::chmod(folder.c_str(), 0700) != 0) refuse(folder);
  forceToDisk(folder);
}

void writePrivateFile(const fs::path& path, const std::string& content) {
  WholeFile file(path);
  const int descriptor = ::open(file.temporaryPath().c_str(), O_WRONLY | O_CREAT | O_EXCL, 0600);
  if (descriptor < 0) refuse(path);
  for (std::size_t done = 0; done < content.size();) {
    const ssize_t written = ::write(descriptor, content.data() + done, content.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      ::close(descriptor);
      refuse(path);
    }
    done += std::size_t(written);
  }
  ::close(descriptor);
  file.commit();
}

void replaceFolder(const fs::path& fresh, const fs::path& folder) {
  if (!fs::exists(folder)) {
    if (::rename(fresh.c_str(), folder.c_str()) != 0) refuse(folder);
  } else if (::renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, folder.c_str(), RENAME_EXCHANGE) == 0) {
    std::error_code ignored;
    fs::remove_all(fresh, ignored);  // holds the old content now
  } else {                           // a file system that cannot swap: the old one steps aside first
    const fs::path aside = fresh.string() + "_old";
    if (::rename(folder.c_str(), aside.c_str()) != 0) refuse(folder);
    if (::rename(fresh.c_str(), folder.c_str()) != 0) {
      const int reason = errno;
      ::rename(aside.c_str(), folder.c_str());
      errno = reason;
      refuse(folder);
    }
    std::error_code ignored;
    fs::remove_all(aside, ignored);
  }
  forceToDisk(parentOf(folder));
}

TemporarySibling::TemporarySibling(const fs::path& folder) {
  static std::atomic<int> counter{0};
  const fs::path parent = parentOf(folder);
  if (!fs::is_directory(parent)) throw Error("folder does not exist", parent.string(), "create it first");
  path_ = parent / (".tmp" + std::to_string(::getpid()) + "_" + std::to_string(counter++) + "_" +
                    folder.filename().string());
  makePrivateFolder(path_);
}

TemporarySibling::~TemporarySibling() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string utcNow() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  ::gmtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y%m%dT%H%M%SZ", &parts);
  return text;
}

}  // namespace facenav::casefile
