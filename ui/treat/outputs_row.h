#pragma once
// OutputsRow: switches the OpenIGTLink server and other outputs (OSC, JSON, LSL, InVesalius's relay) on and
// off, and lists who is connected and what a robot says.

#include <QTimer>
#include <QWidget>

#include "treat/treat_presenter.h"

class QCheckBox;
class QLineEdit;

namespace facenav::ui {

class ElidedLabel;

class OutputsRow : public QWidget {
  Q_OBJECT

 public:
  explicit OutputsRow(TreatPresenter& treat, QWidget* parent = nullptr);

 private:
  QWidget* makeServer();
  QWidget* makeOthers();
  void send();
  void showState();

  TreatPresenter& treat_;
  QCheckBox *serve_, *send_;
  QLineEdit* others_;
  ElidedLabel* receivers_;
  QTimer timer_;
};

}  // namespace facenav::ui
