#pragma once
// DosePanel: the dose of a session: the case's protocol, or the active target's own dose. Also the coil that
// the case is planned for.

#include <QFrame>

#include "plan/plan_presenter.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace facenav::ui {

class DosePanel : public QFrame {
  Q_OBJECT

 public:
  explicit DosePanel(PlanPresenter& presenter, QWidget* parent = nullptr);

 signals:
  /// The user wants to choose a file; a menu that contains this panel closes.
  void choosing();

 private:
  void makeFields();
  void showPlan();
  void apply();

  PlanPresenter& presenter_;
  QLabel *protocol_, *coil_, *duration_, *fault_;
  QPushButton *choose_, *remove_, *choose_coil_, *apply_;
  QComboBox* library_coil_;
  QCheckBox* is_own_;
  QSpinBox *pulses_, *trains_;
  QDoubleSpinBox *frequency_, *pause_, *output_, *threshold_;
};

}  // namespace facenav::ui
