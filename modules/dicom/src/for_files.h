#pragma once
// Work on many files on all cores, with progress and cancel; the first file's error by position is the one
// that is reported, so that a faulty folder gives the same words every time.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "facenav/core/task_monitor.h"

namespace facenav::dicom {

/// How many threads forFiles uses for `count` files.
inline std::size_t workersFor(std::size_t count) {
  constexpr std::size_t kMost = 16, kFewFiles = 8;  // starting a thread takes as long as a few headers
  const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  return std::clamp<std::size_t>(count / kFewFiles, 1, std::min(cores, kMost));
}

/// Calls work(file, worker) for file = 0 .. count - 1, worker = 0 .. workersFor(count) - 1 being the thread's
/// number. `monitor` is called from the caller's thread only; throws what it throws, or the error of the
/// first file that failed.
template <class Work>
void forFiles(std::size_t count, TaskMonitor& monitor, const std::string& step, Work&& work) {
  constexpr std::size_t kReportEvery = 16;
  std::atomic<std::size_t> next{0};
  std::atomic<bool> is_stopped{false};
  std::mutex mutex;
  std::exception_ptr fault;
  std::size_t faulty = count;
  const auto fail = [&](std::size_t file) {  // all files before this one were begun, and are finished
    is_stopped = true;
    const std::lock_guard<std::mutex> lock(mutex);
    if (!fault || file < faulty) {
      fault = std::current_exception();
      faulty = file;
    }
  };
  const auto run = [&](std::size_t worker) {
    std::size_t file = count;
    try {
      while (!is_stopped && (file = next++) < count) {
        if (worker == 0 && file % kReportEvery < workersFor(count))
          monitor.report(step, double(file) / double(count));
        work(file, worker);
      }
    } catch (...) {
      fail(file);
    }
  };
  std::vector<std::thread> others;
  for (std::size_t worker = 1; worker < workersFor(count); ++worker) others.emplace_back(run, worker);
  run(0);
  for (std::thread& other : others) other.join();
  if (fault) std::rethrow_exception(fault);
}

}  // namespace facenav::dicom
