#pragma once
// OutputsRow: switches the OpenIGTLink server for other programs on and off, lists who is connected, and
// shows the newest line about what a client sent, if targets and commands are accepted.

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
  void serve();
  void showState();

  TreatPresenter& treat_;
  QCheckBox *serve_, *accept_;
  ElidedLabel *receivers_, *news_;
  QTimer timer_;
};

}  // namespace facenav::ui
