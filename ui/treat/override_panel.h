#pragma once
// OverridePanel: shown over the Treat workspace while the case is not signed off. It shows this, and takes
// name and reason of a person who treats nevertheless. Not modal. After an override it stays as one line.

#include <QFrame>

#include "treat/treat_presenter.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace facenav::ui {

class OverridePanel : public QFrame {
  Q_OBJECT

 public:
  OverridePanel(TreatPresenter& presenter, CaseModel& model, QWidget* parent = nullptr);

 private:
  void showState();

  TreatPresenter& presenter_;
  CaseModel& model_;
  QLabel* words_;
  QLineEdit *name_, *reason_;
  QPushButton* override_;
};

}  // namespace facenav::ui
