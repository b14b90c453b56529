#pragma once
// Runs GDCM's codecs in a child process. On damaged streams they print to the terminal, abort on assertions
// (Debian ships GDCM 3.0.21 with them) or write out of bounds. A crash of the child gives an empty result
// here.

#include <cstddef>
#include <functional>
#include <string>

#include "facenav/core/child_process.h"

namespace facenav::dicom {

/// Memory that a child writes and its parent reads; initially zero. Throws std::bad_alloc.
class SharedMemory {
 public:
  explicit SharedMemory(std::size_t bytes);
  ~SharedMemory();
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;
  char* begin() const { return static_cast<char*>(memory_); }
  std::size_t size() const { return size_; }

 private:
  std::size_t size_;
  void* memory_;
};

/// Runs `work` in a child with its output discarded, for at most `time_limit_s` (wall clock). Its results are
/// what it wrote to SharedMemory. Throws Error where no process can be started.
ChildProcess runCodec(const std::function<void()>& work, unsigned time_limit_s = 8);

/// Result of `decode`, computed in such a child. Empty when the child failed or the result has more than
/// `most_bytes`.
std::string runIsolated(const std::function<std::string()>& decode, std::size_t most_bytes);

}  // namespace facenav::dicom
