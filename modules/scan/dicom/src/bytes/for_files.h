#pragma once
// Processes many files on all cores, with progress and cancel. It reports the error of the first faulty file
// by position, so that a faulty folder always gives the same message.

#include <algorithm>
#include <cstddef>
#include <string>

#include "facenav/core/parallel_for.h"
#include "facenav/core/task_monitor.h"

namespace facenav::dicom {

/// Number of threads that forFiles uses for `count` files.
inline std::size_t workersFor(std::size_t count) {
  constexpr std::size_t kMost = 16, kFewFiles = 8;  // starting a thread takes as long as a few headers
  return std::clamp<std::size_t>(count / kFewFiles, 1, std::min(coreCount(), kMost));
}

/// Calls work(file, worker) for file = 0 .. count - 1; worker = 0 .. workersFor(count) - 1 is the thread's
/// number. Calls `monitor` from the caller's thread only. Throws what it throws, or the error of the first
/// file that failed.
template <class Work>
void forFiles(std::size_t count, TaskMonitor& monitor, const std::string& step, Work&& work) {
  constexpr std::size_t kReportEvery = 16;
  const std::size_t workers = workersFor(count);
  parallelFor(count, workers, [&](std::size_t file, std::size_t worker) {
    if (worker == 0 && file % kReportEvery < workers) monitor.report(step, double(file) / double(count));
    work(file, worker);
  });
}

}  // namespace facenav::dicom
