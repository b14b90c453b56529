#pragma once
// EndPanel: the end of a session: a summary, pain afterwards, adverse events; then the report.

#include <QFrame>

#include "treat/treat_presenter.h"

class QComboBox;
class QLabel;
class QLineEdit;

namespace facenav::ui {

class EndPanel : public QFrame {
  Q_OBJECT

 public:
  explicit EndPanel(TreatPresenter& treat, QWidget* parent = nullptr);

 private:
  void showState();
  void end();

  TreatPresenter& treat_;
  QLabel* words_;
  QComboBox* pain_;
  QLineEdit* adverse_;
  bool was_asked_ = false;
};

}  // namespace facenav::ui
