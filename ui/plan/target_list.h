#pragma once
// TargetList: the plan's targets by name, in their order; the chosen one is the active one. Double click or
// F2 renames a target, and a context menu holds what can be done with the one under the mouse.

#include <QListWidget>

#include "plan/plan_presenter.h"

class QMenu;

namespace facenav::ui {

class TargetList : public QListWidget {
  Q_OBJECT

 public:
  explicit TargetList(PlanPresenter& plan, QWidget* parent = nullptr);
  /// Shows only the targets whose name or note holds these words.
  void filter(const QString& words);
  /// Makes the context menu of a target: make active, rename, duplicate, mirror, lock, delete. It is deleted
  /// when it closes.
  QMenu* menuOf(const QString& target);

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  void showPlan();
  void rename(const QString& target);
  void remove(const QString& target);

  PlanPresenter& plan_;
  QString words_;
  bool is_filling_ = false;
};

}  // namespace facenav::ui
