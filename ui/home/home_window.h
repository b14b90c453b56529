#pragma once
// HomeWindow: `facenav-gui --home CASE`: three steps, one sentence, one sign, one big button. Everything by
// keyboard: Return is the big button, P a pulse. Text of any size fits.

#include <QTimer>
#include <QWidget>

#include "home/home_presenter.h"
#include "shell/input_times.h"

class QLabel;
class QPushButton;

namespace facenav::ui {

class FittedWords;
class ImageView;
class SignView;

class HomeWindow : public QWidget {
  Q_OBJECT

 public:
  explicit HomeWindow(const Services& services, QWidget* parent = nullptr);
  ~HomeWindow() override;

  HomePresenter& presenter() { return presenter_; }
  const TaskRunner& tasks() const { return tasks_; }

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void refresh();
  void showSteps(int active, bool is_done);
  void showPicture();
  void press();
  void saveFile();
  QString savedWords() const;

  Services services_;
  TaskRunner tasks_;
  HomePresenter presenter_;
  InputTimes times_;
  FittedWords* steps_[3];
  FittedWords *words_, *counts_;
  SignView* sign_;
  ImageView* picture_;
  QPushButton* button_;
  FittedWords* button_words_;
  QTimer timer_;
  std::int64_t shown_ = -1;
  QStringList places_;  // folders with the saved file
};

}  // namespace facenav::ui
