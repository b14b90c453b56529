#pragma once
// TargetTools: menus for the targets of a plan: presets, a grid, copies and order, and the head's landmarks.

#include <QFrame>

#include "plan/head_presenter.h"
#include "plan/plan_presenter.h"

class QMenu;
class QToolButton;

namespace facenav::ui {

class TargetTools : public QFrame {
  Q_OBJECT

 public:
  TargetTools(PlanPresenter& plan, HeadPresenter& head, QWidget* parent = nullptr);

 signals:
  /// The user marks this landmark at the crosshair.
  void landmarkWanted(facenav::surface::Landmark which);
  void goTo(double x_mm, double y_mm, double z_mm);
  /// Compare the active target with this one; empty: with none.
  void compareWith(const QString& target);

 private:
  QToolButton* button(const QString& words, const QString& tip, QMenu* menu);
  QMenu* presetMenu();
  QMenu* gridMenu();
  QMenu* moreMenu();
  QMenu* headMenu();
  void fillCompareMenu(QMenu* menu);
  void addPreset(const QString& name);

  PlanPresenter& plan_;
  HeadPresenter& head_;
};

}  // namespace facenav::ui
