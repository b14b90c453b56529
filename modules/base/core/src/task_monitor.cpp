#include "facenav/core/task_monitor.h"

#include "facenav/core/error.h"

namespace facenav {
inline namespace core {

void TaskMonitor::report(const std::string& step, double fraction) {
  if (is_cancelled_) throw Cancelled();
  if (listener_) listener_(step, fraction);
}

}  // namespace core
}  // namespace facenav
