#pragma once
// OutputsRow: switches the OpenIGTLink server and other outputs (OSC, JSON, LSL, InVesalius's relay) on and
// off, lists who is connected and what a robot says, and shows the newest line about what a client sent, if
// targets and commands are accepted.

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
  QString otherWords() const;
  void send();
  void showState();

  TreatPresenter& treat_;
  QCheckBox *serve_, *accept_, *send_;
  QLineEdit* others_;
  ElidedLabel *receivers_, *news_;
  QTimer timer_;
};

}  // namespace facenav::ui
