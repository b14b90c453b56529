#pragma once
// PlanEditor: a case's targets under a person's hands: placed, renamed, turned, moved, removed, undone and
// done again. Every step is written into the case at once, by the function handed in; a step that cannot be
// written changes nothing, neither the plan nor what can be undone.

#include <functional>
#include <string>
#include <vector>

#include "facenav/workflow/plan_edits.h"

namespace facenav::workflow {

/// The case as the editor sees it. `plan` and `head` are asked for each step, so that what others change in
/// the case meanwhile is seen. `write` throws where the case cannot be written, and keeps the old plan.
struct PlannedCase {
  std::function<const guidance::TreatmentPlan&()> plan;
  std::function<PlannedHead()> head;
  std::function<void(const guidance::TreatmentPlan&)> write;
  std::function<std::string(int)> numbered;  // "Target 3"
};

class PlanEditor {
 public:
  explicit PlanEditor(PlannedCase planned) : case_(std::move(planned)) {}

  /// Another case: nothing can be undone, its first target is the active one.
  void begin();

  // Places of a new target, which becomes the active one; the handle at 45 degrees. They throw Error, and
  // PlanRefused: outside the head, no brain model.
  void addTarget(const Point<Mri>& cortex_point);
  /// At the brain surface nearest to a place on the scalp.
  void addTargetAtScalp(const Point<Mri>& scalp_point);
  /// At the place itself where it lies in the brain, else at the place of the cortex nearest to it.
  void addTargetNear(const Point<Mri>& point);

  // Of the active target; nothing happens where there is none.
  void remove();
  /// Throws PlanRefused where another target has the name.
  void rename(const std::string& name);
  void replace(const guidance::Target& target);
  /// > 0 clockwise as seen along the coil's z.
  void turn(double angle_rad);
  /// Along the scalp, in the coil's x and y (mm); handle and gap stay. Throws Error where no scalp lies
  /// there.
  void nudge(double x_mm, double y_mm);

  /// The target that the step had changed becomes the active one. False: there is no step.
  bool undo();
  bool redo();
  bool canUndo() const { return !undo_.empty(); }
  bool canRedo() const { return !redo_.empty(); }

  void setActive(const std::string& name) { active_ = name; }
  const std::string& activeName() const { return active_; }
  /// Null where there is none.
  const guidance::Target* active() const { return find(case_.plan(), active_); }

 private:
  /// The plan and its active target before and after a step.
  struct Step {
    guidance::TreatmentPlan before, after;
    std::string active_before, active_after;
  };
  void apply(const guidance::TreatmentPlan& next, const std::string& active);

  PlannedCase case_;
  std::string active_;
  std::vector<Step> undo_, redo_;
};

}  // namespace facenav::workflow
