#include "prepare/field_queue.h"

#include <sys/resource.h>

#include <algorithm>

#include "facenav/core/log.h"

namespace facenav::ui {
namespace {

constexpr int kFieldNiceness = 15;  // niceness, below that of preparing

}  // namespace

FieldQueue::FieldQueue(const Services& services, QObject* parent) : QObject(parent), services_(services) {
  connect(&tasks_, &TaskRunner::cancelled, this, [this] { end(false); });
  connect(&tasks_, &TaskRunner::failed, this, [this](const QString& words) {
    // The planning page then names the local sphere as its model.
    logWarning("electric field of " + folders_.front().filename().string() + ": " + tasks_.failure());
    end(true, words);
  });
}

FieldQueue::~FieldQueue() { disconnect(&tasks_, nullptr, this, nullptr); }

void FieldQueue::add(const QString& case_folder) {
  if (!services_.buildField) return;
  const std::filesystem::path folder(case_folder.toStdString());
  if (std::find(folders_.begin(), folders_.end(), folder) == folders_.end()) folders_.push_back(folder);
  begin();
}

void FieldQueue::setHeld(bool is_held) {
  if (std::exchange(is_held_, is_held) == is_held) return;
  if (is_held && tasks_.isRunning()) tasks_.cancel();
  begin();
}

void FieldQueue::begin() {
  if (is_held_ || folders_.empty() || tasks_.isRunning()) return;
  tasks_.start(tr("Electric field"), [this, folder = folders_.front()](TaskMonitor& monitor) {
    ::setpriority(PRIO_PROCESS, 0, kFieldNiceness);
    services_.buildField(folder, monitor);
    return TaskRunner::Delivery([this] { end(true); });
  });
}

void FieldQueue::end(bool is_done, const QString& failure) {
  if (is_done) {
    const QString folder = QString::fromStdString(folders_.front().string());
    folders_.pop_front();
    emit ended(folder, failure);
  }
  QMetaObject::invokeMethod(this, &FieldQueue::begin, Qt::QueuedConnection);
}

}  // namespace facenav::ui
