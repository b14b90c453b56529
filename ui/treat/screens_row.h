#pragma once
// ScreensRow: opens and closes the guidance screen on the patient's side and the projector's window.

#include <QWidget>

#include "shell/second_screens.h"

class QPushButton;

namespace facenav::ui {

class ScreensRow : public QWidget {
  Q_OBJECT

 public:
  ScreensRow(SecondScreens& screens, ProjectorPresenter& projector, QWidget* parent = nullptr);

 private:
  void showState();
  void toggleProjector(bool is_shown);

  SecondScreens& screens_;
  ProjectorPresenter& projector_;
  QPushButton *guidance_, *projector_button_;
};

}  // namespace facenav::ui
