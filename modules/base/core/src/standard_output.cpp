#include "facenav/core/standard_output.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <vector>

#include "durable.h"
#include "facenav/core/error.h"

namespace facenav {
inline namespace core {
namespace {

std::atomic<int> g_output{STDOUT_FILENO};  // where files go

void writeAll(const char* bytes, std::size_t size) {
  for (std::size_t done = 0; done < size;) {
    const ssize_t written = ::write(g_output, bytes + done, size - done);
    if (written < 0 && errno != EINTR) refuseWriting("standard output");
    if (written > 0) done += std::size_t(written);
  }
}

}  // namespace

bool isStandardOutput(const std::filesystem::path& path) { return path == "-"; }

void keepStandardOutputForFiles() {
  if (g_output != STDOUT_FILENO) return;
  std::fflush(stdout);
  const int kept = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  if (kept < 0 || ::dup2(STDERR_FILENO, STDOUT_FILENO) < 0) refuseWriting("standard output");
  g_output = kept;
}

void copyToStandardOutput(const std::filesystem::path& file) {
  std::fflush(stdout);
  std::ifstream stream(file, std::ios::binary);
  std::vector<char> bytes(1 << 16);
  while (stream.read(bytes.data(), std::streamsize(bytes.size())) || stream.gcount() > 0)
    writeAll(bytes.data(), std::size_t(stream.gcount()));
  if (!stream.eof()) throw Error("cannot be read back", file.string(), "check free disk space");
}

}  // namespace core
}  // namespace facenav
