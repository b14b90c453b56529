#include "facenav/plan/plan_editor.h"

#include <algorithm>
#include <chrono>
#include <memory>

#include "facenav/core/utc_time.h"
#include "facenav/guidance/handle.h"

namespace facenav::steps {

PlannedCase plannedCase(const casefile::CaseStore& store, const std::string& by) {
  const auto plan = std::make_shared<guidance::TreatmentPlan>(store.targets());
  const auto head = std::make_shared<PlannedHead>(plannedHead(store));
  return {[plan]() -> const guidance::TreatmentPlan& { return *plan; }, [head] { return *head; },
          [plan, store](const guidance::TreatmentPlan& next) {
            store.setTargets(next);
            *plan = next;
          },
          [](int n) { return "Target " + std::to_string(n); }, [by] { return by; }};
}

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

guidance::Target PlanEditor::stamped(guidance::Target target, const std::string& what) const {
  constexpr double kOneStep_s = 10;  // repeated changes within this time are one step: a key held down
  const guidance::Change change{isoUtc(std::chrono::system_clock::now()),
                                case_.by ? case_.by() : std::string(), what};
  const auto isSame = [&](const guidance::Change& last) {
    const auto before = secondsOfUtc(last.utc), now = secondsOfUtc(change.utc);
    return last.what == what && last.by == change.by && before && now && *now - *before < kOneStep_s;
  };
  if (!target.changes.empty() && isSame(target.changes.back())) target.changes.pop_back();
  target.changes.push_back(change);
  return target;
}

void PlanEditor::requireUnlocked() const {
  if (active() && active()->is_locked)
    throw PlanRefused(PlanRefusal::locked, "the target '" + active_ + "' is locked", "unlock it first");
}

/// Returns the plan with the seed's grid made anew; targets of it that were edited by hand or locked stay.
guidance::TreatmentPlan PlanEditor::withGrid(guidance::TreatmentPlan plan,
                                             const guidance::Target& seed) const {
  const auto isKept = [](const guidance::Target& t) { return t.grid_place->is_edited || t.is_locked; };
  const auto isOld = [&](const guidance::Target& t) {
    return t.grid_place && t.grid_place->seed == seed.name && !isKept(t);
  };
  plan.targets.erase(std::remove_if(plan.targets.begin(), plan.targets.end(), isOld), plan.targets.end());
  if (!seed.grid) return plan;
  for (const auto& target : gridTargets(case_.head(), seed, *seed.grid))
    if (!find(plan, target.name)) plan = with(std::move(plan), target.name, stamped(target, "grid"));
  return plan;
}

void PlanEditor::put(guidance::Target target, const std::string& what) {
  requireUnlocked();
  if (target.grid_place) target.grid_place->is_edited = true;
  auto next = with(case_.plan(), active_, stamped(target, what));
  if (target.grid) next = withGrid(std::move(next), target);
  apply(next, target.name);
}

void PlanEditor::addTarget(const Point<Mri>& cortex_point) {
  const auto head = case_.head();
  requireInHead(head, cortex_point, 0.0);
  const std::string name = freeName(case_.plan(), case_.numbered);
  apply(with(case_.plan(), name, stamped(targetOverCortex(head, name, cortex_point), "planned")), name);
}

void PlanEditor::addTargetAtScalp(const Point<Mri>& scalp_point) {
  const std::string name = freeName(case_.plan(), case_.numbered);
  apply(with(case_.plan(), name, stamped(targetOnScalp(case_.head(), name, scalp_point), "planned")), name);
}

void PlanEditor::addTargetNear(const Point<Mri>& point) { addTarget(cortexNear(case_.head(), point)); }

void PlanEditor::addTarget(const PresetPlace& place, const std::string& name, const CoilWish& wish) {
  const auto head = case_.head();
  const auto* old = find(case_.plan(), name);
  if (old && old->is_locked)
    throw PlanRefused(PlanRefusal::locked, "the target '" + name + "' is locked", "unlock it first");
  auto target = place.scalp ? targetOnScalp(head, name, *place.scalp, wish)
                            : targetOverCortex(head, name, cortexNear(head, *place.cortex), wish);
  if (old) target.changes = old->changes;
  target.note = place.words;
  apply(with(case_.plan(), name, stamped(target, "planned")), name);
}

void PlanEditor::remove() {
  if (!active()) return;
  requireUnlocked();
  auto seed = *active();
  seed.grid.reset();
  const auto next = without(withGrid(case_.plan(), seed), active_);
  apply(next, next.targets.empty() ? std::string() : next.targets.back().name);
}

void PlanEditor::replace(const guidance::Target& target, const std::string& what) {
  if (!active()) return;
  requireUnlocked();
  const auto head = case_.head();
  put(guidance::settleOnHead(target, *head.scalp, head.plate), what);
}

void PlanEditor::rename(const std::string& name) {
  if (!active() || name.empty() || name == active_) return;
  if (find(case_.plan(), name))
    throw PlanRefused(PlanRefusal::name_taken, "there is a target '" + name + "' already",
                      "choose another name");
  requireUnlocked();
  auto renamed = *active();
  renamed.name = name;
  auto next = with(case_.plan(), active_, stamped(renamed, "renamed from '" + active_ + "'"));
  for (auto& target : next.targets)
    if (target.grid_place && target.grid_place->seed == active_) target.grid_place->seed = name;
  apply(next, name);
}

void PlanEditor::duplicate() {
  if (!active()) return;
  auto copy = *active();
  copy.name = freeName(case_.plan(), [&](int n) {
    return active_ + " copy" + (n > 1 ? " " + std::to_string(n) : std::string());
  });
  copy.grid.reset();
  copy.grid_place.reset();
  copy.is_locked = false;
  copy.changes.clear();
  apply(with(case_.plan(), copy.name, stamped(copy, "copied from '" + active_ + "'")), copy.name);
}

void PlanEditor::mirror(const std::function<Point<Mri>(const Point<Mri>&)>& mirrored) {
  if (!active()) return;
  auto other = mirroredTarget(case_.head(), *active(), mirrored);
  other.name = freeName(case_.plan(), [&](int n) {
    return active_ + " mirrored" + (n > 1 ? " " + std::to_string(n) : std::string());
  });
  apply(with(case_.plan(), other.name, stamped(other, "mirrored from '" + active_ + "'")), other.name);
}

void PlanEditor::setNote(const std::string& note) {
  if (!active() || active()->note == note) return;
  requireUnlocked();
  auto target = *active();
  target.note = note;
  apply(with(case_.plan(), active_, stamped(target, "note")), active_);
}

void PlanEditor::setLocked(bool is_locked) {
  if (!active() || active()->is_locked == is_locked) return;
  auto target = *active();
  target.is_locked = is_locked;
  apply(with(case_.plan(), active_, stamped(target, is_locked ? "locked" : "unlocked")), active_);
}

void PlanEditor::setDose(const std::optional<guidance::Dose>& dose) {
  if (!active() || active()->dose == dose) return;
  requireUnlocked();
  if (dose) guidance::requireSensible(*dose);
  auto target = *active();
  target.dose = dose;
  apply(with(case_.plan(), active_, stamped(target, "dose")), active_);
}

void PlanEditor::setGrid(const std::optional<guidance::GridSpec>& grid) {
  if (!active()) return;
  requireUnlocked();
  auto seed = *active();
  seed.grid = grid;
  apply(withGrid(with(case_.plan(), active_, stamped(seed, grid ? "grid" : "grid removed")), seed), active_);
}

void PlanEditor::move(int places) {
  if (!active()) return;
  auto next = case_.plan();
  const auto here = std::find_if(next.targets.begin(), next.targets.end(),
                                 [&](const auto& t) { return t.name == active_; });
  const auto from = here - next.targets.begin(), to = from + places;
  if (to < 0 || to >= std::ptrdiff_t(next.targets.size())) return;
  std::swap(next.targets[std::size_t(from)], next.targets[std::size_t(to)]);
  apply(next, active_);
}

void PlanEditor::turn(double angle_rad) {
  if (active()) replace(turned(*active(), angle_rad), "turned");
}

void PlanEditor::nudge(double x_mm, double y_mm) {
  if (!active()) return;
  requireUnlocked();
  const auto head = case_.head();
  put(guidance::movedOnHead(*active(), *head.scalp, head.plate, x_mm, y_mm), "moved");
}

/// Makes `wanted` the active target after a step was undone or done again, unless another one was chosen
/// since and still exists.
void PlanEditor::follow(const std::string& chosen_then, const std::string& wanted) {
  if (active_ == chosen_then || !active()) active_ = wanted;
}

bool PlanEditor::undo() {
  if (undo_.empty()) return false;
  case_.write(undo_.back().before);
  follow(undo_.back().active_after, undo_.back().active_before);
  redo_.push_back(undo_.back());
  undo_.pop_back();
  return true;
}

bool PlanEditor::redo() {
  if (redo_.empty()) return false;
  case_.write(redo_.back().after);
  follow(redo_.back().active_before, redo_.back().active_after);
  undo_.push_back(redo_.back());
  redo_.pop_back();
  return true;
}

}  // namespace facenav::steps
