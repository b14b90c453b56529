#pragma once
// parallelFor: independent items on several cores; the one parallel loop of FaceNav. Items are begun in
// order, a core that is done takes the next one. The threads are the process' own (oneTBB's, which VTK uses
// too): loops that run at the same time share them, and one that gets none does all its items itself. Work in
// the background (a thread with a nice value above the process') stays there: its loops run on threads of
// their own at its priority.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>

namespace facenav {
inline namespace core {

/// The machine's, at least 1; 1 while a OneCoreOnly lives.
std::size_t coreCount();

/// While one lives, parallelRanges and what else asks coreCount() run on the caller's thread alone, in the
/// whole program: for time measured on one core. Libraries' own loops (OpenCV's) are not held back.
class OneCoreOnly {
 public:
  OneCoreOnly();
  ~OneCoreOnly();
  OneCoreOnly(const OneCoreOnly&) = delete;
  OneCoreOnly& operator=(const OneCoreOnly&) = delete;
};

/// Calls run(worker) for worker = 0 .. `workers` - 1, 0 on the caller's thread, and returns when all have.
/// `run` must not throw, nor wait for another worker: there may be one thread for all.
void runOnWorkers(std::size_t workers, const std::function<void(std::size_t)>& run);

/// Calls work(item, worker) for item = 0 .. `count` - 1, with worker < `workers`: no two calls with one
/// worker's number run at the same time, and worker 0 is the caller's thread. When items throw, no further
/// ones are begun, and of those that threw the first one's exception is thrown here; a cancel is such an
/// exception.
template <class Work>
void parallelFor(std::size_t count, std::size_t workers, Work&& work) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> is_stopped{false};
  std::mutex mutex;
  std::exception_ptr fault;
  std::size_t faulty = count;
  runOnWorkers(workers < count ? workers : count, [&](std::size_t worker) {
    for (std::size_t item; !is_stopped && (item = next++) < count;) {
      try {
        work(item, worker);
      } catch (...) {  // all items before this one were begun, and are finished
        is_stopped = true;
        const std::lock_guard<std::mutex> lock(mutex);
        if (!fault || item < faulty) fault = std::current_exception(), faulty = item;
      }
    }
  });
  if (fault) std::rethrow_exception(fault);
}

/// Calls work(begin, end) for ranges that together are `first` .. `last` - 1 (rows of an image, slices), on
/// all cores. What work() does must not depend on where ranges begin. It throws as parallelFor does.
template <class Work>
void parallelRanges(int first, int last, Work&& work) {
  constexpr std::size_t kRangesACore = 4;  // so that none waits long for the last one
  if (last <= first) return;
  const std::size_t count = std::size_t(last - first), cores = coreCount();
  const std::size_t ranges = cores == 1 ? 1 : std::min(kRangesACore * cores, count);
  parallelFor(ranges, cores, [&](std::size_t range, std::size_t) {
    work(first + int(range * count / ranges), first + int((range + 1) * count / ranges));
  });
}

}  // namespace core
}  // namespace facenav
