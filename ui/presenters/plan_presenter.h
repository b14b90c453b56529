#pragma once
// PlanPresenter: binds the window to workflow/plan_editor.h: targets on the cortex, made by a click, turned,
// renamed, removed; every step can be undone and is saved in the case at once.

#include <QObject>

#include "facenav/workflow/plan_editor.h"
#include "presenters/case_model.h"

namespace facenav::ui {

class PlanPresenter : public QObject {
  Q_OBJECT

 public:
  explicit PlanPresenter(CaseModel& model, QObject* parent = nullptr);

  /// A new target under the scalp at a point of the cortex, the handle at 45 degrees; it becomes the active
  /// one. Refused for a point outside the head.
  void addTarget(const Point<Mri>& cortex_point);
  /// A click on the scalp means the brain surface nearest below it.
  void addTargetAtScalp(const Point<Mri>& scalp_point);
  /// At the point itself where it lies in the brain, else at the place of the cortex nearest to it. Refused
  /// where the point lies more than surface::kFarthestOutside_mm outside the head.
  void addTargetNear(const Point<Mri>& point);
  void removeActive();
  void renameActive(const QString& name);
  /// Turns the handle; > 0 as seen along the coil's z, clockwise.
  void turnActive(double degrees);
  /// The active target's handle angle (as handleAngle_deg) and gap, as typed: "+45", "-12,5°", "4 mm". What
  /// is no number, or lies outside guidance's ranges, is refused in one line.
  void setHandle(const QString& typed);
  void setGap(const QString& typed);
  /// Moves the active target along the scalp (Coil x and y, mm); its handle keeps its direction, the coil its
  /// gap.
  void nudgeActive(double x_mm, double y_mm);
  /// The target that the step had changed becomes the active one. Where the case cannot be written nothing
  /// changes, refused() says why, and the step can be tried again.
  void undo();
  void redo();

  bool canUndo() const { return editor_.canUndo(); }
  bool canRedo() const { return editor_.canRedo(); }
  const guidance::TreatmentPlan& plan() const;
  void setActive(const QString& name);
  QString activeName() const { return QString::fromStdString(editor_.activeName()); }
  const guidance::Target* active() const;
  /// "+45" (or "+43.7") and "4.0", as the fields show them; empty without an active target.
  QString handleFigure() const;
  QString gapFigure() const;
  /// Angle of the handle, -180..180 degrees, as guidance::handleAngle gives it. Only while a case is open, as
  /// are those below.
  double handleAngle_deg(const guidance::Target& target) const;
  /// "handle +45° from anterior (+ to the midline)".
  QString handleWords(const guidance::Target& target) const;
  /// "L37 P21 S58", "14 mm below the skin, gap 4.0 mm", and the handle; one line each.
  QString describe(const guidance::Target& target) const;

 signals:
  void changed();
  void refused(const QString& words);

 private:
  workflow::PlannedCase planned();
  /// changed(), or refused() with the reason; `name`: what the edit was to be called.
  template <class Edit>
  void attempt(Edit edit, const QString& name = {});
  void replaceActive(const guidance::Target& target);
  template <class Change>
  void setTyped(const QString& typed, const QString& unit, Change change);

  CaseModel& model_;
  workflow::PlanEditor editor_;
};

}  // namespace facenav::ui
