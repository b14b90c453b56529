#pragma once
// HandlePanel: the active target's handle angle, gap and tilt; the first two are typed or changed step by
// step. A value that is refused is explained below its field until something else is typed or done.

#include <QFrame>

#include "plan/plan_presenter.h"

class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace facenav::ui {

class HandlePanel : public QFrame {
  Q_OBJECT

 public:
  explicit HandlePanel(PlanPresenter& presenter, QWidget* parent = nullptr);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// A field for one number, and why the last one was refused.
  struct Field {
    QLineEdit* line;
    QLabel* fault;
  };
  Field field(const QString& name, const QString& tip, QString (PlanPresenter::*set)(const QString&));
  void addRow(QGridLayout& grid, int row, const QString& words, const Field& field);
  void showFigures();
  void showPlan();

  PlanPresenter& presenter_;
  Field angle_, gap_;
  QLabel* contact_;
  QPushButton *left_, *right_;
};

}  // namespace facenav::ui
