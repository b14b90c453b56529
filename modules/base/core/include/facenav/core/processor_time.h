#pragma once
// Processor time of a step: the sum over all threads of this program, independent of other load on the
// machine.

#include <ctime>

namespace facenav {
inline namespace core {

/// Processor time of this program so far, ms. Only differences mean anything.
inline double processorTime_ms() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

}  // namespace core
}  // namespace facenav
