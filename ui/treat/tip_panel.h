#pragma once
// TipPanel: the tool Check of Treat: the MRI's skin over the pictures (on or off), the position of the coil's
// tip or of a clicked spot on the MRI's skin, and two buttons for a person's judgement.

#include <QFrame>

#include "treat/tip_presenter.h"

class QCheckBox;
class QLabel;
class QPushButton;

namespace facenav::ui {

class TipPanel : public QFrame {
  Q_OBJECT

 public:
  TipPanel(TipPresenter& tip, TreatPresenter& treat, QWidget* parent = nullptr);

 private:
  QWidget* makeFigures();
  QWidget* makeJudgement();
  void showState();

  TipPresenter& tip_;
  TreatPresenter& treat_;
  QCheckBox* skin_;
  QLabel *off_skin_, *off_place_, *skin_words_, *place_words_, *words_;
  QPushButton *right_, *wrong_;
};

}  // namespace facenav::ui
