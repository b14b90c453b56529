#pragma once
// TaskRunner: runs one long task at a time on a worker thread, with progress and cancel, and delivers its
// result on the GUI thread. One of the few places that catch Error.

#include <QElapsedTimer>
#include <QObject>
#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "facenav/core/task_monitor.h"

namespace facenav::ui {

class TaskRunner : public QObject {
  Q_OBJECT

 public:
  /// Uses the result, on the GUI thread.
  using Delivery = std::function<void()>;
  /// The work, on the worker thread; throws Error or Cancelled.
  using Work = std::function<Delivery(TaskMonitor&)>;

  explicit TaskRunner(QObject* parent = nullptr);
  /// Cancels and waits.
  ~TaskRunner() override;

  /// Returns false and does nothing while another task runs.
  bool start(const QString& title, Work work);
  void cancel();
  bool isRunning() const { return is_running_; }
  /// Why the last task failed, in English as in the log; empty if it did not.
  const std::string& failure() const { return failure_; }

 signals:
  void started(const QString& title);
  void progressed(const QString& step, double fraction);
  void succeeded();
  void failed(const QString& words);  // in the window's language
  void cancelled();

 private:
  void finish(const Delivery& delivery, const std::string& failure, bool was_cancelled);

  std::thread thread_;
  std::shared_ptr<TaskMonitor> monitor_;
  bool is_running_ = false;
  std::string failure_;
};

}  // namespace facenav::ui
