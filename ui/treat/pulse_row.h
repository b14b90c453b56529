#pragma once
// PulseRow: the pulses of the session by their verdict, its time, the fault of the last pulse, and the button
// that counts one.

#include <QWidget>

#include "shell/input_times.h"
#include "treat/session_sounds.h"
#include "treat/treat_presenter.h"

class QLabel;
class QPushButton;

namespace facenav::ui {

class ElidedLabel;

class PulseRow : public QWidget {
  Q_OBJECT

 public:
  PulseRow(TreatPresenter& treat, SessionSounds& sounds, QWidget* parent = nullptr);

  /// Counts a pulse at the time when its key or button was pressed.
  void take();
  /// Refreshes the row; called about 30 times a second.
  void refresh();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QString pulseWords() const;
  QString countWords() const;
  void showLastPulse();
  void fitLastPulse();

  TreatPresenter& treat_;
  SessionSounds& sounds_;
  InputTimes times_;
  ElidedLabel* pulses_;
  QLabel* time_;
  QPushButton* pulse_;
  ElidedLabel* counts_;
  QLabel* last_pulse_;
  int shown_pulse_ = 0;
};

}  // namespace facenav::ui
