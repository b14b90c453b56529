#pragma once
// PlanPresenter: binds the window to plan/plan_editor.h. It adds targets on the cortex by a click, and
// turns, renames and removes them. Every step can be undone and is saved in the case at once.

#include <QObject>

#include "facenav/plan/plan_editor.h"
#include "facenav/scene/coil_slices.h"
#include "shell/case_model.h"

namespace facenav::ui {

class PlanPresenter : public QObject {
  Q_OBJECT

 public:
  explicit PlanPresenter(CaseModel& model, QObject* parent = nullptr);

  /// Adds a target at a point of the cortex, under the scalp, with the handle at 45 degrees. It becomes the
  /// active one. Refused for a point outside the head.
  void addTarget(const Point<Mri>& cortex_point);
  /// Adds a target at the brain surface nearest to a click on the scalp.
  void addTargetAtScalp(const Point<Mri>& scalp_point);
  /// Adds a target at the point itself if it lies in the brain, else at the nearest point of the cortex.
  /// Refused if the point lies more than surface::kFarthestOutside_mm outside the head.
  void addTargetNear(const Point<Mri>& point);
  /// Adds a target at a preset (plan/presets.h), under the preset's name; replaces one of the same name.
  /// Refused if the head has no such place.
  void addPreset(const QString& preset, const steps::HeadMeasures& measures);
  void removeActive();
  void renameActive(const QString& name);
  /// Turns the handle; > 0 is clockwise when seen along the coil's z.
  void turnActive(double degrees);
  /// Sets the active target's handle angle (as handleAngle_deg) or gap from typed text: "+45", "-12,5°", "4
  /// mm". Returns why it is refused, in one line for the place beside the field: no number, outside
  /// guidance's ranges, a locked target. Empty if it is taken; refused() is not emitted.
  QString setHandle(const QString& typed);
  QString setGap(const QString& typed);
  /// Moves the active target along the scalp (Coil x and y, mm). The handle's direction and the gap stay.
  void nudgeActive(double x_mm, double y_mm);
  /// Gives the active target the pose of another one; what it is for, its name and note stay. `what`: for the
  /// record of changes.
  void takePose(const guidance::Target& pose, const std::string& what);
  /// Copies the active target, or mirrors it through the atlas; the copy becomes the active one.
  void duplicateActive();
  void mirrorActive();
  /// A locked target can be neither changed nor removed.
  void lockActive(bool is_locked);
  void setNote(const QString& note);
  /// Sets the active target's own dose; empty: the protocol's dose applies. Refused outside its ranges.
  void setDose(const std::optional<guidance::Dose>& dose);
  /// Uses a copy of this protocol file for the case, or none. Refused as casefile::setProtocol.
  void setProtocol(const QString& file);
  void removeProtocol();
  /// Plans the case for this coil.json; targets keep their poses until they are edited.
  void setCoil(const QString& file);
  /// Names of the usable coils of the library.
  QStringList libraryCoils() const;
  /// Sets the coil by its name in the library, as setCoil does by its file.
  void setCoilNamed(const QString& name);
  /// Sets a grid around the active target, or removes it. Its targets that were edited by hand stay.
  void setGrid(const std::optional<guidance::GridSpec>& grid);
  /// Takes a plan with imported targets, as one step. Throws Error if it cannot be written; nothing has
  /// changed then, and refused() is not emitted.
  void takePlan(const guidance::TreatmentPlan& next, const QString& active);
  /// Has everything that shows the plan look again: a file beside it has changed.
  void showAgain() { emit changed(); }
  /// Moves the active target up (-1) or down (1) in the list.
  void moveActive(int places);
  /// Undoes the last step. The target that was active before it is active again, unless another one was
  /// chosen since: that one stays active. If the case cannot be written nothing changes, refused() gives the
  /// reason, and the step can be tried again.
  void undo();
  void redo();

  bool canUndo() const { return editor_.canUndo(); }
  bool canRedo() const { return editor_.canRedo(); }
  const guidance::TreatmentPlan& plan() const;
  void setActive(const QString& name);
  QString activeName() const { return QString::fromStdString(editor_.activeName()); }
  const guidance::Target* active() const;
  /// The active target's coil with the error that the case's alignment predicts there; empty without a
  /// target.
  std::optional<scene::SlicedCoil> slicedCoil() const;
  /// Texts of the fields: "+45" (or "+43.7") and "4.0"; empty without an active target.
  QString handleFigure() const;
  QString gapFigure() const;
  /// Angle of the handle, -180..180 degrees, as guidance::handleAngle gives it. This and the functions below
  /// are valid only while a case is open.
  double handleAngle_deg(const guidance::Target& target) const;
  /// "handle +45° from anterior (+ to the midline)".
  QString handleWords(const guidance::Target& target) const;
  /// "rests flat on the head", or the distance of its centre from the skin, its tilt and its contacts.
  QString contactWords(const guidance::Target& target) const;
  /// Differences between the active target and another one, in mm and degrees.
  QString compareWords(const QString& other) const;
  /// The active target's own dose, else the protocol's; empty if neither gives one.
  std::optional<guidance::Dose> doseInForce() const;
  /// "'M1 10 Hz', version 2: 3000 pulses", or that there is none, or why it cannot be read.
  QString protocolWords() const;
  /// Duration of the dose in force: "25 min 0 s"; empty if it is not known.
  QString durationWords() const;
  QString coilWords() const;
  /// "cortex 14 mm below the scalp", by guidance::cortexDepth_mm.
  QString depthWords(const guidance::Target& target) const;
  /// Describes a target, one item a line: "L37 P21 S58", depth and gap, the handle, the contact.
  QString describe(const guidance::Target& target) const;

 signals:
  void changed();
  void refused(const QString& words);

 private:
  steps::PlannedCase planned();
  /// Runs the edit, then emits changed(), or refused() with the reason. `name`: the wanted name of the
  /// target.
  template <class Edit>
  void attempt(Edit edit, const QString& name = {});
  /// Runs the edit, then emits changed(), or returns why it is refused.
  template <class Edit>
  QString refusalOf(Edit edit, const QString& name = {});
  template <class Change>
  QString setTyped(const QString& typed, const QString& unit, Change change);

  CaseModel& model_;
  steps::PlanEditor editor_;
};

}  // namespace facenav::ui
