#pragma once
// PlanEditor: edits of a case's targets: add, rename, turn, move, remove, copy, mirror, grid, lock, undo,
// redo. Every step is written into the case at once, by the given function. A step that cannot be written
// changes nothing: neither the plan nor the undo list. The coil's plate rests on the head after each step.
// Every changed target records when, by whom and what.

#include <functional>
#include <string>
#include <vector>

#include "facenav/plan/plan_edits.h"
#include "facenav/plan/presets.h"

namespace facenav::steps {

/// Access to the case. `plan` and `head` are read at each step, so that changes by others are included.
/// `write` throws if the case cannot be written, and then keeps the old plan.
struct PlannedCase {
  std::function<const guidance::TreatmentPlan&()> plan;
  std::function<PlannedHead()> head;
  std::function<void(const guidance::TreatmentPlan&)> write;
  std::function<std::string(int)> numbered;  // "Target 3"
  std::function<std::string()> by = {};      // who edits; absent: unknown
};
/// Access to a case on disk, for the command line.
PlannedCase plannedCase(const casefile::CaseStore& store, const std::string& by);

class PlanEditor {
 public:
  explicit PlanEditor(PlannedCase planned) : case_(std::move(planned)) {}

  /// Starts with another case: the undo list is empty, its first target is the active one.
  void begin();

  // The next functions add a target, which becomes the active one, with the handle at 45 degrees. They throw
  // Error, and PlanRefused: outside the head, no brain model.
  void addTarget(const Point<Mri>& cortex_point);
  /// Adds a target at the brain surface nearest to a point of the scalp.
  void addTargetAtScalp(const Point<Mri>& scalp_point);
  /// Adds a target at the point itself if it lies in the brain, else at the nearest point of the cortex.
  void addTargetNear(const Point<Mri>& point);
  /// Adds a target at a point of the cortex or the scalp (placeOf of a preset), with this name. Replaces one
  /// of the same name, unless it is locked.
  void addTarget(const PresetPlace& place, const std::string& name, const CoilWish& wish = {});

  // The next functions edit the active target; they do nothing if there is none. All but setLocked,
  // duplicate, mirror and move throw PlanRefused if it is locked. A target of a grid that is edited by hand
  // no longer follows the grid; a moved seed moves its grid.
  void remove();
  /// Renames the target. Throws PlanRefused if another target has the name.
  void rename(const std::string& name);
  /// Sets another pose, or gap; the plate then rests on the head there.
  void replace(const guidance::Target& target, const std::string& what = "changed");
  /// Copies the target under a free name ("M1 copy"); the copy becomes the active one.
  void duplicate();
  /// Adds the target of the other side of the head under a free name; it becomes the active one.
  void mirror(const std::function<Point<Mri>(const Point<Mri>&)>& mirrored);
  void setNote(const std::string& note);
  void setLocked(bool is_locked);
  void setDose(const std::optional<guidance::Dose>& dose);
  /// Makes or replaces the target's grid; nothing removes it. Targets of the grid that were edited by hand
  /// stay.
  void setGrid(const std::optional<guidance::GridSpec>& grid);
  /// Moves the target up (-1) or down (1) in the list.
  void move(int places);
  /// Turns the target; > 0 clockwise when seen along the coil's z.
  void turn(double angle_rad);
  /// Moves the target along the scalp, in the coil's x and y (mm). The handle's direction and the gap stay
  /// (guidance::movedOnHead). Throws Error if there is no scalp at the new position.
  void nudge(double x_mm, double y_mm);

  /// Takes a plan that was made elsewhere from this one, as one step.
  void take(const guidance::TreatmentPlan& next, const std::string& active) { apply(next, active); }

  /// Undoes a step. The active target is the one from before the step; a target that was chosen since stays
  /// the active one. Returns false if there is no step.
  bool undo();
  bool redo();
  bool canUndo() const { return !undo_.empty(); }
  bool canRedo() const { return !redo_.empty(); }

  void setActive(const std::string& name) { active_ = name; }
  const std::string& activeName() const { return active_; }
  /// The active target; null if there is none.
  const guidance::Target* active() const { return find(case_.plan(), active_); }

 private:
  /// The plan and its active target before and after a step.
  struct Step {
    guidance::TreatmentPlan before, after;
    std::string active_before, active_after;
  };
  void apply(const guidance::TreatmentPlan& next, const std::string& active);
  void follow(const std::string& chosen_then, const std::string& wanted);
  /// Throws PlanRefused if the active target is locked.
  void requireUnlocked() const;
  /// Replaces the active target, with a record of the change.
  void put(guidance::Target target, const std::string& what);
  guidance::Target stamped(guidance::Target target, const std::string& what) const;
  guidance::TreatmentPlan withGrid(guidance::TreatmentPlan plan, const guidance::Target& seed) const;

  PlannedCase case_;
  std::string active_;
  std::vector<Step> undo_, redo_;
};

}  // namespace facenav::steps
