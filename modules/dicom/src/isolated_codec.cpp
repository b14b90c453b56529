#include "isolated_codec.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <new>
#include <utility>

#include "facenav/core/error.h"

namespace facenav::dicom {
namespace {

[[noreturn]] void runChild(const std::function<void()>& work, unsigned time_limit_s) {
  for (const int signal : {SIGALRM, SIGABRT, SIGSEGV, SIGINT, SIGTERM}) ::signal(signal, SIG_DFL);
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  ::alarm(time_limit_s);
  const int nowhere = ::open("/dev/null", O_WRONLY);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  try {
    work();
    ::_exit(0);
  } catch (...) {
    ::_exit(1);
  }
}

}  // namespace

SharedMemory::SharedMemory(std::size_t bytes) : size_(bytes) {
  memory_ = ::mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory_ == MAP_FAILED) throw std::bad_alloc();
}

SharedMemory::~SharedMemory() { ::munmap(memory_, size_); }

ChildProcess::ChildProcess(const std::function<void()>& work, unsigned time_limit_s) : process_(::fork()) {
  if (process_ < 0)
    throw Error("no process could be started to decompress images", {}, "close other programs");
  if (process_ == 0) runChild(work, time_limit_s);
}

ChildProcess::~ChildProcess() {
  if (process_ < 0) return;
  ::kill(process_, SIGKILL);
  wait();
}

bool ChildProcess::wait() {
  const int process = std::exchange(process_, -1);
  int status = 0;
  while (::waitpid(process, &status, 0) < 0)
    if (errno != EINTR) return false;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::string runIsolated(const std::function<std::string()>& decode, std::size_t most_bytes) {
  const SharedMemory result(sizeof(std::size_t) + most_bytes);  // the length, then the bytes
  ChildProcess child([&] {
    const std::string bytes = decode();
    const std::size_t length = bytes.size();
    if (length > most_bytes) throw Error("more than was asked for");
    std::memcpy(result.begin() + sizeof length, bytes.data(), length);
    std::memcpy(result.begin(), &length, sizeof length);
  });
  const bool is_done = child.wait();
  std::size_t length = 0;
  std::memcpy(&length, result.begin(), sizeof length);
  if (!is_done || length > most_bytes) return {};
  return {result.begin() + sizeof length, length};
}

}  // namespace facenav::dicom
