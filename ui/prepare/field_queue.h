#pragma once
// FieldQueue: builds the electric field's model of prepared cases in the background, one at a time, while
// nothing else is prepared and nobody is treated. A case without such a model uses the local sphere.

#include <QObject>
#include <deque>
#include <filesystem>

#include "shell/services.h"
#include "shell/task_runner.h"

namespace facenav::ui {

class FieldQueue : public QObject {
  Q_OBJECT

 public:
  /// `services` must outlive the queue. Without services.buildField nothing is built.
  explicit FieldQueue(const Services& services, QObject* parent = nullptr);
  ~FieldQueue() override;

  /// Queues a case; one that waits or is under way is not queued twice.
  void add(const QString& case_folder);
  /// While held nothing is built; a model under way is begun again later.
  void setHeld(bool is_held);
  bool isIdle() const { return folders_.empty() && !tasks_.isRunning(); }

 signals:
  /// A case's model was built, or could not be: `failure` says why, and is empty otherwise.
  void ended(const QString& case_folder, const QString& failure);

 private:
  void begin();
  void end(bool is_done, const QString& failure = {});

  const Services& services_;
  TaskRunner tasks_;
  std::deque<std::filesystem::path> folders_;
  bool is_held_ = false;
};

}  // namespace facenav::ui
