#include "facenav/core/parallel_for.h"

#include <sys/resource.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace facenav {
inline namespace core {

namespace {

std::atomic<int> one_core_only{0};

/// True if the thread's nice value is above the process'. Shared threads would do its work at normal
/// priority.
bool isBackgroundThread() {
  return ::getpriority(PRIO_PROCESS, 0) > ::getpriority(PRIO_PROCESS, id_t(::getpid()));
}

/// Uses new threads, which inherit the caller's nice value.
void runOnOwnThreads(std::size_t workers, const std::function<void(std::size_t)>& run) {
  std::vector<std::thread> others;
  for (std::size_t worker = 1; worker < workers; ++worker) others.emplace_back(run, worker);
  run(0);
  for (std::thread& other : others) other.join();
}

}  // namespace

std::size_t coreCount() { return one_core_only > 0 ? 1 : std::max(1u, std::thread::hardware_concurrency()); }

OneCoreOnly::OneCoreOnly() { ++one_core_only; }
OneCoreOnly::~OneCoreOnly() { --one_core_only; }

void runOnWorkers(std::size_t workers, const std::function<void(std::size_t)>& run) {
  if (workers == 0) return;
  if (workers == 1) return run(0);
  if (isBackgroundThread()) return runOnOwnThreads(workers, run);
  tbb::this_task_arena::isolate([&] {  // a nested loop that waits takes no item of the outer one
    tbb::task_group others;
    for (std::size_t worker = 1; worker < workers; ++worker) others.run([&run, worker] { run(worker); });
    run(0);
    others.wait();
  });
}

}  // namespace core
}  // namespace facenav
