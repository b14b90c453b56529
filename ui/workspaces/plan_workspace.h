#pragma once
// Plan: linked slices, cortex and scalp with the coil's ghost, list of targets.

#include <QWidget>

#include "presenters/plan_presenter.h"

class QLabel;
class QListWidget;
class QPushButton;

namespace facenav::ui {

class LinkedViews;

class PlanWorkspace : public QWidget {
  Q_OBJECT

 public:
  PlanWorkspace(PlanPresenter& presenter, CaseModel& model, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* makeTargetsPanel();
  QWidget* makeHandleRow();
  void addKeys();
  void showCase();
  void showPlan();

  PlanPresenter& presenter_;
  CaseModel& model_;
  LinkedViews* views_;
  QListWidget* targets_;
  QLabel* detail_;
  QPushButton *undo_, *redo_, *remove_;
  bool is_outdated_ = false, is_filling_ = false;
};

}  // namespace facenav::ui
