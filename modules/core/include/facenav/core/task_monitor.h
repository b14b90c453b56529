#pragma once
// TaskMonitor: how a long task (segmentation, alignment, simulation) reports progress and learns that the
// user cancelled. The task calls report() now and then; it throws Cancelled when cancel() was called, from
// any thread.

#include <atomic>
#include <functional>
#include <string>

namespace facenav {
inline namespace core {

class TaskMonitor {
 public:
  /// Called with the step's name and the fraction done of it (0..1), on the task's thread.
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
