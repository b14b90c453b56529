#include "evaluate/measured_child.h"

#include <chrono>

#include "facenav/core/child_process.h"

namespace facenav::app {

ChildMeasure measureInChild(const std::function<void()>& task) {
  const auto start = std::chrono::steady_clock::now();
  const ChildEnd end = ChildProcess::run(task).wait();
  ChildMeasure measure;
  measure.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  measure.processor_s = end.processor_s;
  measure.peak_mib = end.peak_mib;
  measure.failure = end.failure;
  if (measure.failure.empty() && !end.isDone())
    measure.failure = end.signal != 0 ? "killed by signal " + std::to_string(end.signal) : "failed";
  return measure;
}

}  // namespace facenav::app
