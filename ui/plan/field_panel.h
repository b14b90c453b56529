#pragma once
// FieldPanel: choices of the electric field: the switch, the coil, and the rate of its current; below them
// the region that the field reaches.

#include <QFrame>

#include "plan/field_presenter.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;

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

  FieldPresenter& presenter_;
  QCheckBox* is_on_;
  QComboBox *coil_, *unit_;
  QDoubleSpinBox* rate_;
  QLabel* reach_;
};

}  // namespace facenav::ui
