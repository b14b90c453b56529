#pragma once
// TaskBar: step, percentage, time left and Cancel of the running task; else the last message.

#include <QElapsedTimer>
#include <QFrame>

class QProgressBar;
class QPushButton;

namespace facenav::ui {

class ElidedLabel;
class TaskRunner;

class TaskBar : public QFrame {
  Q_OBJECT

 public:
  TaskBar(TaskRunner& tasks, QWidget* parent = nullptr);
  void showMessage(const QString& words, bool is_failure);
  /// Shows something to do, not a failure.
  void showNotice(const QString& words);

 private:
  void say(const QString& words, bool is_caution);
  void setBusy(bool is_busy);
  void showProgress(const QString& step, double fraction);

  const TaskRunner& tasks_;
  ElidedLabel* words_;
  QProgressBar* bar_;
  QPushButton* cancel_;
  QElapsedTimer elapsed_, said_;  // said_: time since the last message
  QString title_;
};

}  // namespace facenav::ui
