#pragma once
// parallelFor: FaceNav's one parallel loop, for independent items. Items are started in order; a free core
// takes the next one. The threads are oneTBB's, which VTK uses too. Loops that run at the same time share
// them; a loop that gets none runs all its items on the caller's thread. Background work (a thread with a
// nice value above the process') runs its loops on separate threads at its own priority.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>

namespace facenav {
inline namespace core {

/// Cores of the machine, at least 1; 1 while a OneCoreOnly exists.
std::size_t coreCount();

/// While one exists, parallelRanges and all other users of coreCount() run on the caller's thread alone, in
/// the whole program. Use it to measure time on one core. It does not limit the loops of libraries (OpenCV).
class OneCoreOnly {
 public:
  OneCoreOnly();
  ~OneCoreOnly();
  OneCoreOnly(const OneCoreOnly&) = delete;
  OneCoreOnly& operator=(const OneCoreOnly&) = delete;
};

/// Calls run(worker) for worker = 0 .. `workers` - 1 and returns when all are done. Worker 0 is the caller's
/// thread. `run` must not throw and must not wait for another worker, since one thread may run them all.
void runOnWorkers(std::size_t workers, const std::function<void(std::size_t)>& run);

/// Calls work(item, worker) for item = 0 .. `count` - 1, with worker < `workers`. Two calls with the same
/// worker number never run at the same time; worker 0 is the caller's thread. When an item throws, no further
/// items are started, and the exception of the first item that threw is rethrown here. Cancelling is such an
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
      } catch (...) {  // all items before this one were started and will finish
        is_stopped = true;
        const std::lock_guard<std::mutex> lock(mutex);
        if (!fault || item < faulty) fault = std::current_exception(), faulty = item;
      }
    }
  });
  if (fault) std::rethrow_exception(fault);
}

/// Calls work(begin, end) on all cores, for ranges that together are `first` .. `last` - 1 (rows of an image,
/// slices). The result of work() must not depend on where ranges begin. It throws as parallelFor does.
template <class Work>
void parallelRanges(int first, int last, Work&& work) {
  constexpr std::size_t kRangesACore = 4;  // small ranges, so that no core waits long for the last one
  if (last <= first) return;
  const std::size_t count = std::size_t(last - first), cores = coreCount();
  const std::size_t ranges = cores == 1 ? 1 : std::min(kRangesACore * cores, count);
  parallelFor(ranges, cores, [&](std::size_t range, std::size_t) {
    work(first + int(range * count / ranges), first + int((range + 1) * count / ranges));
  });
}

}  // namespace core
}  // namespace facenav
