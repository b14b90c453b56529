#pragma once
// FieldPanel: choices of the electric field: the switch, the coil, the rate of its current, and the model
// with the fluid; below them the region that the field reaches.

#include <QFrame>

#include "plan/field_presenter.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace facenav::ui {

class FieldPanel : public QFrame {
  Q_OBJECT

 public:
  explicit FieldPanel(FieldPresenter& presenter, QWidget* parent = nullptr);

 signals:
  /// The user wants to choose a file; a menu that contains this panel closes.
  void choosing();

 private:
  void choose(int item);
  void showChoices();
  void showReach();
  void showFluid();
  void fitMenu();

  FieldPresenter& presenter_;
  QCheckBox *is_on_, *imported_;
  QComboBox *coil_, *unit_;
  QDoubleSpinBox* rate_;
  QLabel* reach_;
  QPushButton* fluid_;
};

}  // namespace facenav::ui
