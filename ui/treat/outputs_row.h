#pragma once
// OutputsRow: switches the OpenIGTLink server for other programs on and off, and lists who is connected.

#include <QTimer>
#include <QWidget>

#include "treat/treat_presenter.h"

class QCheckBox;

namespace facenav::ui {

class ElidedLabel;

class OutputsRow : public QWidget {
  Q_OBJECT

 public:
  explicit OutputsRow(TreatPresenter& treat, QWidget* parent = nullptr);

 private:
  void showState();

  TreatPresenter& treat_;
  QCheckBox* serve_;
  ElidedLabel* receivers_;
  QTimer timer_;
};

}  // namespace facenav::ui
