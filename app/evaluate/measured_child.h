#pragma once
// A task in a process of its own, so that its time and memory are its own and its crash takes nothing else
// down.

#include <functional>
#include <string>

namespace facenav::app {

struct ChildMeasure {
  double wall_s = 0, processor_s = 0, peak_mib = 0;  // peak: resident set, with what the parent held already
  std::string failure;                               // empty: the task came to its end
};

/// Forks, runs `task`, waits. What the task makes it must leave in files. An exception is its failure. Call
/// it while no other thread runs.
ChildMeasure measureInChild(const std::function<void()>& task);

}  // namespace facenav::app
