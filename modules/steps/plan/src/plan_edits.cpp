#include "facenav/plan/plan_edits.h"

#include <algorithm>
#include <cmath>

#include "facenav/casefile/case_coil.h"
#include "facenav/surface/closest_point.h"
#include "facenav/surface/outside_head.h"

namespace facenav::steps {

PlannedHead plannedHead(const casefile::CaseStore& store) {
  PlannedHead head;
  head.scalp = std::make_shared<const surface::ScalpSurface>(store.scalp());
  head.head_mask = std::make_shared<const volume::Mask>(store.headMask());
  if (auto brain = store.brain()) head.brain = std::make_shared<const surface::BrainModel>(std::move(*brain));
  head.plate = casefile::coilOf(store.folder()).plate;
  return head;
}

void requireInHead(const PlannedHead& head, const Point<Mri>& p, double limit_mm) {
  const double outside_mm = surface::outsideHead_mm(*head.head_mask, *head.scalp, p);
  if (outside_mm > limit_mm)
    throw PlanRefused(PlanRefusal::outside_head,
                      "the place lies " + std::to_string(std::lround(outside_mm)) + " mm outside the head",
                      "check the numbers, and whether they are MNI or RAS", outside_mm);
}

Point<Mri> cortexNear(const PlannedHead& head, const Point<Mri>& p) {
  requireInHead(head, p, surface::kFarthestOutside_mm);
  if (!head.brain) return p;
  const auto nearest = surface::ClosestPoint(head.brain->mesh).nearest(p);
  return nearest.is_outside ? nearest.point : p;
}

Point<Mri> cortexUnder(const PlannedHead& head, const Point<Mri>& scalp_point) {
  if (!head.brain)
    throw PlanRefused(PlanRefusal::no_brain, "no brain model", "click on the slice where the target lies");
  Eigen::Vector3d best = scalp_point.mm;
  double least = 1e300;
  for (const auto& v : head.brain->mesh.vertices_mm)
    if (const double d = (v - scalp_point.mm).squaredNorm(); d < least) least = d, best = v;
  return Point<Mri>(best);
}

guidance::Target turned(const guidance::Target& target, double angle_rad) {
  auto result = target;
  const RigidTransform<frames::Target, frames::Target> about_z(
      Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitZ())), Eigen::Vector3d::Zero());
  result.mri_T_target = target.mri_T_target * about_z;
  return result;
}

guidance::TreatmentPlan with(guidance::TreatmentPlan plan, const std::string& name,
                             const guidance::Target& target) {
  for (auto& known : plan.targets)
    if (known.name == name) {
      known = target;
      return plan;
    }
  plan.targets.push_back(target);
  return plan;
}

guidance::TreatmentPlan without(guidance::TreatmentPlan plan, const std::string& name) {
  const auto is_named = [&](const guidance::Target& t) { return t.name == name; };
  plan.targets.erase(std::remove_if(plan.targets.begin(), plan.targets.end(), is_named), plan.targets.end());
  return plan;
}

const guidance::Target* find(const guidance::TreatmentPlan& plan, const std::string& name) {
  for (const auto& target : plan.targets)
    if (target.name == name) return &target;
  return nullptr;
}

std::string freeName(const guidance::TreatmentPlan& plan, const std::function<std::string(int)>& numbered) {
  int n = 1;
  while (find(plan, numbered(n))) ++n;
  return numbered(n);
}

}  // namespace facenav::steps
