#pragma once
// SecondCoilRow: the choice of a second coil, its target, and which of both coils gives the pulses. Coil and
// pulses are chosen before a session; the target at any time.

#include <QWidget>

#include "treat/treat_presenter.h"

class QComboBox;

namespace facenav::ui {

class SecondCoilRow : public QWidget {
  Q_OBJECT

 public:
  explicit SecondCoilRow(TreatPresenter& treat, QWidget* parent = nullptr);

 private:
  void showState();

  TreatPresenter& treat_;
  QComboBox *coil_, *target_, *pulses_;
};

}  // namespace facenav::ui
