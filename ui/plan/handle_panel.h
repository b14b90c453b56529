#pragma once
// HandlePanel: the active target's handle angle and gap, typed or changed step by step.

#include <QFrame>

#include "plan/plan_presenter.h"

class QLineEdit;

namespace facenav::ui {

class HandlePanel : public QFrame {
  Q_OBJECT

 public:
  explicit HandlePanel(PlanPresenter& presenter, QWidget* parent = nullptr);

 private:
  QLineEdit* field(const QString& name, const QString& tip, void (PlanPresenter::*set)(const QString&));
  void showFigures();

  PlanPresenter& presenter_;
  QLineEdit *angle_, *gap_;
};

}  // namespace facenav::ui
