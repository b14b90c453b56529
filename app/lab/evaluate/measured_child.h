#pragma once
// Runs a task in its own process, to measure its time and memory alone and to survive its crash.

#include <functional>
#include <string>

namespace facenav::app {

struct ChildMeasure {
  // Peak: resident set, including the parent's memory at the fork.
  double wall_s = 0, processor_s = 0, peak_mib = 0;
  std::string failure;  // empty if the task finished
};

/// Forks, runs `task`, waits. The task must write its results to files. An exception becomes `failure`. Call
/// it only while no other thread runs.
ChildMeasure measureInChild(const std::function<void()>& task);

}  // namespace facenav::app
