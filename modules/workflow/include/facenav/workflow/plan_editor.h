#pragma once
// PlanEditor: edits of a case's targets: add, rename, turn, move, remove, undo, redo. Every step is written
// into the case at once, by the function handed in. A step that cannot be written changes nothing: neither
// the plan nor the undo list.

#include <functional>
#include <string>
#include <vector>

#include "facenav/workflow/plan_edits.h"

namespace facenav::workflow {

/// The case as the editor sees it. `plan` and `head` are read at each step, so that changes by others are
/// seen. `write` throws if the case cannot be written, and then keeps the old plan.
struct PlannedCase {
  std::function<const guidance::TreatmentPlan&()> plan;
  std::function<PlannedHead()> head;
  std::function<void(const guidance::TreatmentPlan&)> write;
  std::function<std::string(int)> numbered;  // "Target 3"
};

class PlanEditor {
 public:
  explicit PlanEditor(PlannedCase planned) : case_(std::move(planned)) {}

  /// Starts with another case: the undo list is empty, its first target is the active one.
  void begin();

  // Add a target, which becomes the active one, with the handle at 45 degrees. They throw Error, and
  // PlanRefused: outside the head, no brain model.
  void addTarget(const Point<Mri>& cortex_point);
  /// At the brain surface nearest to a point of the scalp.
  void addTargetAtScalp(const Point<Mri>& scalp_point);
  /// At the point itself if it lies in the brain, else at the nearest point of the cortex.
  void addTargetNear(const Point<Mri>& point);

  // Edit the active target; they do nothing if there is none.
  void remove();
  /// Throws PlanRefused if another target has the name.
  void rename(const std::string& name);
  void replace(const guidance::Target& target);
  /// > 0 clockwise when seen along the coil's z.
  void turn(double angle_rad);
  /// Moves along the scalp, in the coil's x and y (mm). Handle angle and gap stay. Throws Error if there is
  /// no scalp at the new place.
  void nudge(double x_mm, double y_mm);

  /// The target changed by the undone step becomes the active one. Returns false if there is no step.
  bool undo();
  bool redo();
  bool canUndo() const { return !undo_.empty(); }
  bool canRedo() const { return !redo_.empty(); }

  void setActive(const std::string& name) { active_ = name; }
  const std::string& activeName() const { return active_; }
  /// Null if there is none.
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
