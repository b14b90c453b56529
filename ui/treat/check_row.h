#pragma once
// CheckRow: result of the last registration check in one line, and the button that checks again.

#include <QWidget>

#include "treat/check_presenter.h"

class QPushButton;

namespace facenav::ui {

class ElidedLabel;

class CheckRow : public QWidget {
  Q_OBJECT

 public:
  explicit CheckRow(CheckPresenter& check, TreatPresenter& treat, QWidget* parent = nullptr);

 private:
  void showState();

  CheckPresenter& check_;
  TreatPresenter& treat_;
  ElidedLabel* words_;
  QPushButton* button_;
};

}  // namespace facenav::ui
