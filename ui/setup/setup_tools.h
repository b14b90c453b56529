#pragma once
// SetupTools: the choices and buttons of a set-up step, beside its pictures: the cameras (1), the board (2),
// the rig's name (3), the coil (4).

#include <QStackedWidget>

#include "setup/setup_presenter.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QVBoxLayout;

namespace facenav::ui {

class CameraFields;

class SetupTools : public QStackedWidget {
  Q_OBJECT

 public:
  explicit SetupTools(SetupPresenter& presenter, QWidget* parent = nullptr);
  /// Shows the current step and what can be done now.
  void refresh();

 private:
  QVBoxLayout* addPage();
  QPushButton* addButton(QVBoxLayout& column, const QString& text, const QString& tip);
  QLabel* addWords(QVBoxLayout& column, const QString& text, const char* name);
  void makeCameras();
  void makeBoard();
  void makeCheck();
  void makeCoil();
  void fillDevices();
  void fillCoils();
  void boardEdited();
  void keep();
  void print();
  void chooseJig();

  SetupPresenter& presenter_;
  CameraFields* cameras_;
  QComboBox *kept_, *coil_;
  QSpinBox *columns_, *rows_;
  QDoubleSpinBox* square_;
  QLineEdit* name_;
  QLabel *device_words_, *name_trouble_, *views_, *result_, *kept_words_, *coil_words_;
  QPushButton *open_, *open_kept_, *finish_, *more_, *repeat_, *keep_, *repair_, *pivot_, *keep_coil_, *wave_;
};

}  // namespace facenav::ui
