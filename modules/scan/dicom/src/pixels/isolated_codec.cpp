#include "isolated_codec.h"

#include <sys/mman.h>

#include <cstring>
#include <new>

#include "facenav/core/error.h"

namespace facenav::dicom {
SharedMemory::SharedMemory(std::size_t bytes) : size_(bytes) {
  memory_ = ::mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory_ == MAP_FAILED) throw std::bad_alloc();
}

SharedMemory::~SharedMemory() { ::munmap(memory_, size_); }

ChildProcess runCodec(const std::function<void()>& work, unsigned time_limit_s) {
  ChildOptions options;
  options.output = ChildOptions::Output::nowhere;
  options.time_limit_s = time_limit_s;
  options.may_crash = true;
  return ChildProcess::run(work, options);
}

std::string runIsolated(const std::function<std::string()>& decode, std::size_t most_bytes) {
  const SharedMemory result(sizeof(std::size_t) + most_bytes);  // length, then bytes
  ChildProcess child = runCodec([&] {
    const std::string bytes = decode();
    const std::size_t length = bytes.size();
    if (length > most_bytes) throw Error("more than was asked for");
    std::memcpy(result.begin() + sizeof length, bytes.data(), length);
    std::memcpy(result.begin(), &length, sizeof length);
  });
  const bool is_done = child.wait().isDone();
  std::size_t length = 0;
  std::memcpy(&length, result.begin(), sizeof length);
  if (!is_done || length > most_bytes) return {};
  return {result.begin() + sizeof length, length};
}

}  // namespace facenav::dicom
