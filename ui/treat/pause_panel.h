#pragma once
// PausePanel: the full-width banner of a pause: its reason and length, and how to go on.

#include <QFrame>

#include "treat/treat_presenter.h"

class QLabel;

namespace facenav::ui {

class PausePanel : public QFrame {
  Q_OBJECT

 public:
  explicit PausePanel(TreatPresenter& treat, QWidget* parent = nullptr);
  /// Shows the pause's length; called about 30 times a second.
  void refresh();

 private:
  void showState();

  TreatPresenter& treat_;
  QLabel* words_;
};

}  // namespace facenav::ui
