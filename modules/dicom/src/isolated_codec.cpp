#include "isolated_codec.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "facenav/core/error.h"

namespace facenav::dicom {
namespace {

/// Memory that parent and child both see: the result's length, then its bytes.
class SharedResult {
 public:
  explicit SharedResult(std::size_t most_bytes)
      : capacity_(most_bytes), size_(most_bytes + sizeof(std::size_t)) {
    memory_ = ::mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory_ == MAP_FAILED) throw std::bad_alloc();
  }
  ~SharedResult() { ::munmap(memory_, size_); }
  SharedResult(const SharedResult&) = delete;
  SharedResult& operator=(const SharedResult&) = delete;

  bool put(const std::string& bytes) {
    if (bytes.size() > capacity_) return false;
    const std::size_t length = bytes.size();
    std::memcpy(memory_, &length, sizeof length);
    std::memcpy(static_cast<char*>(memory_) + sizeof length, bytes.data(), length);
    return true;
  }
  std::string take() const {
    std::size_t length = 0;
    std::memcpy(&length, memory_, sizeof length);
    if (length > capacity_) return {};
    return {static_cast<const char*>(memory_) + sizeof length, length};
  }

 private:
  std::size_t capacity_, size_;
  void* memory_;
};

[[noreturn]] void runChild(const std::function<std::string()>& decode, SharedResult& result,
                           unsigned time_limit_s) {
  for (const int signal : {SIGALRM, SIGABRT, SIGSEGV, SIGINT, SIGTERM}) ::signal(signal, SIG_DFL);
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  ::alarm(time_limit_s);
  const int nowhere = ::open("/dev/null", O_WRONLY);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  try {
    ::_exit(result.put(decode()) ? 0 : 1);
  } catch (...) {
    ::_exit(1);
  }
}

}  // namespace

std::string runIsolated(const std::function<std::string()>& decode, std::size_t most_bytes,
                        unsigned time_limit_s) {
  SharedResult result(most_bytes);
  const pid_t child = ::fork();
  if (child < 0) throw Error("no process could be started to decompress images", {}, "close other programs");
  if (child == 0) runChild(decode, result, time_limit_s);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return {};
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? result.take() : std::string();
}

}  // namespace facenav::dicom
