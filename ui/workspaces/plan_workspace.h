#pragma once
// Plan: linked slices, cortex and scalp with the coil's ghost, list of targets.

#include <QWidget>

#include "presenters/place_presenter.h"
#include "presenters/plan_presenter.h"

class QLabel;
class QListWidget;
class QPushButton;

namespace facenav::ui {

class LinkedViews;
class PlacePanel;

class PlanWorkspace : public QWidget {
  Q_OBJECT

 public:
  PlanWorkspace(PlanPresenter& presenter, PlacePresenter& place, CaseModel& model, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* makeTargetsPanel();
  QWidget* makeHandleRow();
  void addKeys();
  void showCase();
  void showPlan();

  PlanPresenter& presenter_;
  PlacePresenter& place_;
  CaseModel& model_;
  LinkedViews* views_;
  PlacePanel* place_panel_;
  QListWidget* targets_;
  QLabel* detail_;
  QPushButton *undo_, *redo_, *remove_;
  bool is_outdated_ = false, is_filling_ = false;
};

}  // namespace facenav::ui
