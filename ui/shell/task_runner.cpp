#include "shell/task_runner.h"

#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/core/timestamp.h"
#include "shell/shown_words.h"

namespace facenav::ui {

TaskRunner::TaskRunner(QObject* parent) : QObject(parent) {}

TaskRunner::~TaskRunner() {
  cancel();
  if (thread_.joinable()) thread_.join();
}

bool TaskRunner::start(const QString& title, Work work) {
  if (is_running_) return false;
  if (thread_.joinable()) thread_.join();
  is_running_ = true;
  emit started(title);
  auto last_report_s = std::make_shared<std::atomic<double>>(0.0);
  monitor_ = std::make_shared<TaskMonitor>([this, last_report_s](const std::string& step, double fraction) {
    const double now_s = Timestamp::now().s;
    if (now_s - *last_report_s < 0.05 && fraction < 1.0) return;  // 20 Hz is fast enough to look smooth
    *last_report_s = now_s;
    const QString words = shownWords(step);
    QMetaObject::invokeMethod(
        this, [this, words, fraction] { emit progressed(words, fraction); }, Qt::QueuedConnection);
  });
  thread_ = std::thread([this, monitor = monitor_, work = std::move(work)] {
    Delivery delivery;
    std::string failure;
    bool was_cancelled = false;
    try {
      delivery = work(*monitor);
    } catch (const Cancelled&) {
      was_cancelled = true;
    } catch (const std::exception& error) {
      failure = error.what();
    }
    QMetaObject::invokeMethod(
        this, [this, delivery, failure, was_cancelled] { finish(delivery, failure, was_cancelled); },
        Qt::QueuedConnection);
  });
  return true;
}

void TaskRunner::cancel() {
  if (monitor_) monitor_->cancel();
}

void TaskRunner::finish(const Delivery& delivery, const std::string& failure, bool was_cancelled) {
  if (thread_.joinable()) thread_.join();
  is_running_ = false;
  failure_ = failure;
  if (!was_cancelled && failure_.empty() && delivery) {
    try {
      delivery();
    } catch (const std::exception& error) {
      failure_ = error.what();
    }
  }
  if (was_cancelled) {
    emit cancelled();
  } else if (!failure_.empty()) {
    logWarning(failure_);
    emit failed(shownWords(failure_));
  } else {
    emit succeeded();
  }
}

}  // namespace facenav::ui
