#pragma once
// GridPanel: rows, columns and spacing of a grid around the active target.

#include <QFrame>

#include "plan/plan_presenter.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace facenav::ui {

class GridPanel : public QFrame {
  Q_OBJECT

 public:
  explicit GridPanel(PlanPresenter& presenter, QWidget* parent = nullptr);

 signals:
  void done();

 private:
  void make();
  void set(const std::optional<guidance::GridSpec>& grid);
  void showFault(const QString& words);
  void showActive();

  PlanPresenter& presenter_;
  QSpinBox *rows_, *columns_;
  QDoubleSpinBox* spacing_;
  QComboBox* on_;
  QPushButton *make_, *remove_;
  QLabel* fault_;
};

}  // namespace facenav::ui
