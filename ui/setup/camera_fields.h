#pragma once
// CameraFields: the fields of step 1 of the set-up: the two cameras and the size of their pictures. What is
// wrong with one stands below it.

#include <QWidget>

#include "setup/setup_presenter.h"

class QComboBox;
class QLabel;
class QVBoxLayout;

namespace facenav::ui {

class CameraFields : public QWidget {
  Q_OBJECT

 public:
  CameraFields(SetupPresenter& presenter, QWidget* parent);
  /// Lists the cameras again, and shows what is wrong with each choice.
  void refresh();

 protected:
  /// Return in a field ends the typing; it does not go on to the next step.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QComboBox* addField(QVBoxLayout& column, const QString& name, const QString& tip, SetupField field);
  void choose();

  SetupPresenter& presenter_;
  QComboBox *left_, *right_, *size_;
  QLabel* troubles_[3] = {};
};

}  // namespace facenav::ui
