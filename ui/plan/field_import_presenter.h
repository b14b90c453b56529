#pragma once
// FieldImportPresenter: takes an electric field that another program computed for the pose of one target
// (plan/imported_field.h). The file is judged on a worker thread, again after each answer; nothing is
// written before takeIn().

#include <QObject>

#include "facenav/plan/imported_field.h"
#include "plan/plan_presenter.h"
#include "shell/task_runner.h"

namespace facenav::ui {

class FieldImportPresenter : public QObject {
  Q_OBJECT

 public:
  FieldImportPresenter(CaseModel& model, PlanPresenter& plan, QObject* parent = nullptr);

  /// Judges the file for the active target. `surface`: of values on a surface; may be empty. Valid only while
  /// a case is open.
  void open(const QString& file, const QString& surface = {});
  const steps::FieldImport& order() const { return order_; }
  /// Changes an answer, and judges again.
  void setTarget(const QString& name);
  void setRate(double rate_A_per_us);
  void setSurface(const QString& file);
  void setT1(const QString& file);
  bool needsSurface() const { return needs_surface_; }
  QStringList targets() const;
  bool isReading() const { return reader_.isRunning() || is_outdated_; }
  /// What was found, or why the field is refused.
  QString words() const;
  bool isRefused() const { return !failure_.isEmpty(); }
  bool canTakeIn() const { return field_ && !isReading(); }
  /// Writes the field into the case; takenIn() or changed() with a refusal follows.
  void takeIn();

 signals:
  void changed();
  void takenIn(const QString& words);

 private:
  void judge();
  void goOn();

  CaseModel& model_;
  PlanPresenter& plan_;
  TaskRunner reader_;
  steps::FieldImport order_;
  std::optional<steps::ImportedField> field_;
  QString failure_;
  bool needs_surface_ = false, is_outdated_ = false;
};

}  // namespace facenav::ui
