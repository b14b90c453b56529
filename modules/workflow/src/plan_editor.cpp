#include "facenav/workflow/plan_editor.h"

#include <cmath>

#include "facenav/guidance/handle.h"

namespace facenav::workflow {
namespace {

constexpr double kUsualHandle_rad = M_PI / 4;

}  // namespace

void PlanEditor::begin() {
  undo_.clear();
  redo_.clear();
  const auto& targets = case_.plan().targets;
  active_ = targets.empty() ? std::string() : targets.front().name;
}

void PlanEditor::apply(const guidance::TreatmentPlan& next, const std::string& active) {
  const Step step{case_.plan(), next, active_, active};
  case_.write(next);
  active_ = active;
  undo_.push_back(step);
  redo_.clear();
}

void PlanEditor::addTarget(const Point<Mri>& cortex_point) {
  const auto head = case_.head();
  requireInHead(head, cortex_point, 0.0);
  const std::string name = freeName(case_.plan(), case_.numbered);
  const auto target = guidance::planTarget(name, *head.scalp, cortex_point, kUsualHandle_rad);
  apply(with(case_.plan(), name, target), name);
}

void PlanEditor::addTargetAtScalp(const Point<Mri>& scalp_point) {
  addTarget(cortexUnder(case_.head(), scalp_point));
}

void PlanEditor::addTargetNear(const Point<Mri>& point) { addTarget(cortexNear(case_.head(), point)); }

void PlanEditor::remove() {
  if (!active()) return;
  const auto next = without(case_.plan(), active_);
  apply(next, next.targets.empty() ? std::string() : next.targets.back().name);
}

void PlanEditor::replace(const guidance::Target& target) {
  if (active()) apply(with(case_.plan(), active_, target), target.name);
}

void PlanEditor::rename(const std::string& name) {
  if (!active() || name.empty() || name == active_) return;
  if (find(case_.plan(), name))
    throw PlanRefused(PlanRefusal::name_taken, "there is a target '" + name + "' already",
                      "choose another name");
  auto renamed = *active();
  renamed.name = name;
  replace(renamed);
}

void PlanEditor::turn(double angle_rad) {
  if (active()) replace(turned(*active(), angle_rad));
}

void PlanEditor::nudge(double x_mm, double y_mm) {
  if (active()) replace(guidance::movedAlongScalp(*active(), *case_.head().scalp, x_mm, y_mm));
}

bool PlanEditor::undo() {
  if (undo_.empty()) return false;
  case_.write(undo_.back().before);
  active_ = undo_.back().active_before;
  redo_.push_back(undo_.back());
  undo_.pop_back();
  return true;
}

bool PlanEditor::redo() {
  if (redo_.empty()) return false;
  case_.write(redo_.back().after);
  active_ = redo_.back().active_after;
  undo_.push_back(redo_.back());
  redo_.pop_back();
  return true;
}

}  // namespace facenav::workflow
