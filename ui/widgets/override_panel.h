#pragma once
// OverridePanel: over the Treat workspace while the case is not signed off: says so, and takes the name and
// reason of who treats nevertheless. Not modal. With an override it stays, one line tall, to say so.

#include <QFrame>

#include "presenters/treat_presenter.h"

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
