#include "facenav/core/parallel_for.h"

#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <thread>

namespace facenav {
inline namespace core {

std::size_t coreCount() { return std::max(1u, std::thread::hardware_concurrency()); }

void runOnWorkers(std::size_t workers, const std::function<void(std::size_t)>& run) {
  if (workers == 0) return;
  if (workers == 1) return run(0);
  tbb::this_task_arena::isolate([&] {  // while it waits, a loop within a loop takes no item of the outer one
    tbb::task_group others;
    for (std::size_t worker = 1; worker < workers; ++worker) others.run([&run, worker] { run(worker); });
    run(0);
    others.wait();
  });
}

}  // namespace core
}  // namespace facenav
