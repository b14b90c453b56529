#pragma once
// SessionPanel: controls of the session that do not concern the coil: pain before and after, adverse events,
// pauses with their reason, source of the pulses, the sounds, who gets the poses, and the other screens.

#include <QFrame>

#include "shell/second_screens.h"
#include "treat/session_sounds.h"
#include "treat/treat_presenter.h"

class QCheckBox;
class QComboBox;
class QLineEdit;
class QPushButton;

namespace facenav::ui {

class SessionPanel : public QFrame {
  Q_OBJECT

 public:
  SessionPanel(TreatPresenter& treat, SessionSounds& sounds, SecondScreens& screens,
               ProjectorPresenter& projector, QWidget* parent = nullptr);

 private:
  QWidget* makePain();
  QWidget* makeAdverse();
  QWidget* makePause();
  QString pauseReason() const;
  QWidget* makeSource();
  QWidget* makeSound();
  void showState();

  TreatPresenter& treat_;
  SessionSounds& sounds_;
  QComboBox* reason_;
  QPushButton* pause_;
  QLineEdit* source_;
  QCheckBox* sound_;
};

}  // namespace facenav::ui
