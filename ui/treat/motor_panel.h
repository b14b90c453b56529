#pragma once
// MotorPanel: hotspot and threshold beside the guidance: the stimulator's output, the muscle's answer to each
// pulse (twitch or MEP), the search for the threshold, the sites of a hunting grid.

#include <QFrame>

#include "treat/motor_presenter.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace facenav::ui {

class MotorPanel : public QFrame {
  Q_OBJECT

 public:
  MotorPanel(MotorPresenter& motor, TreatPresenter& treat, QWidget* parent = nullptr);
  /// Names the newest pulse in the question; called about 30 times a second.
  void showQuestion();

 private:
  QWidget* makeAnswers();
  QWidget* makeSearch();
  QWidget* makeHunt();
  void showState();
  void takeTyped();
  void takeIntensity();

  MotorPresenter& motor_;
  TreatPresenter& treat_;
  QLineEdit *output_, *mep_, *muscle_;
  QPushButton *twitch_, *none_, *search_, *back_, *hunt_, *previous_, *next_;
  QComboBox* method_;
  QLabel *question_, *threshold_, *dose_, *site_;
};

}  // namespace facenav::ui
