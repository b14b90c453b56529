#pragma once
// TaskMonitor: lets a long task (segmentation, alignment, simulation) report progress and learn that the user
// cancelled it. The task calls report() regularly; report() throws Cancelled after cancel() was called on any
// thread.

#include <atomic>
#include <functional>
#include <string>

namespace facenav {
inline namespace core {

class TaskMonitor {
 public:
  /// Called on the task's thread with the step's name and the fraction of it that is done (0..1; less than 0:
  /// it has no end).
  using Listener = std::function<void(const std::string& step, double fraction)>;

  TaskMonitor() = default;
  explicit TaskMonitor(Listener listener) : listener_(std::move(listener)) {}

  /// Reports progress; throws Cancelled after cancel().
  void report(const std::string& step, double fraction);
  void cancel() { is_cancelled_ = true; }
  bool isCancelled() const { return is_cancelled_; }

 private:
  Listener listener_;
  std::atomic<bool> is_cancelled_{false};
};

}  // namespace core
}  // namespace facenav
