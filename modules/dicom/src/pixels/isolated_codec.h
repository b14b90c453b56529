#pragma once
// GDCM's codecs run in a child process: on damaged streams they print to the terminal, abort on assertions
// (Debian ships GDCM 3.0.21 with them) or write out of bounds. The child's end is then this function's empty
// answer.

#include <cstddef>
#include <functional>
#include <string>

#include "facenav/core/child_process.h"

namespace facenav::dicom {

/// Memory that a child writes and its parent reads; zero at first. Throws std::bad_alloc.
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

/// `work` running in a child whose output goes nowhere, for at most `time_limit_s` (of wall clock). What it
/// leaves behind is what it wrote to SharedMemory. Throws Error where no process can be started.
ChildProcess runCodec(const std::function<void()>& work, unsigned time_limit_s = 8);

/// What `decode` returns, computed in such a child. Empty when the child failed or gave more than
/// `most_bytes`.
std::string runIsolated(const std::function<std::string()>& decode, std::size_t most_bytes);

}  // namespace facenav::dicom
