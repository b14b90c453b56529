#pragma once
// Step 4, Sign off: the montage of contours, volumes, each finding with its own tick, name, note.

#include <QWidget>

#include "prepare/sign_off_presenter.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace facenav::ui {

class MontageView;

class SignOffPage : public QWidget {
  Q_OBJECT

 public:
  SignOffPage(SignOffPresenter& presenter, CaseModel& model, QWidget* parent = nullptr);

 signals:
  void lookCloser(double x_mm, double y_mm, double z_mm);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* makePanel();
  void fillItems();
  void showTicks();
  void showState();

  SignOffPresenter& presenter_;
  CaseModel& model_;
  MontageView* montage_;
  QLabel *status_, *volumes_, *missing_;
  QListWidget* items_;
  QLineEdit *name_, *note_;
  QPushButton *sign_, *reject_;
  bool is_outdated_ = false, is_filling_ = false;
};

}  // namespace facenav::ui
