// Makes targets at new points: over the cortex, on the scalp, in a grid, on the other side.

#include <cmath>

#include "facenav/core/number_text.h"
#include "facenav/core/parallel_for.h"
#include "facenav/guidance/handle.h"
#include "facenav/guidance/target_grid.h"
#include "facenav/plan/plan_edits.h"
#include "facenav/surface/closest_point.h"

namespace facenav::steps {
namespace {

using Eigen::Vector3d;

/// Point where the coil's axis meets the brain, from the scalp inwards; else its point nearest to the brain.
Point<Mri> cortexOnAxis(const surface::ClosestPoint& brain, const guidance::Target& target) {
  constexpr double kDeepest_mm = 60, kStep_mm = 0.5;
  const Vector3d z = target.mri_T_target.rotation().col(2);
  Point<Mri> best = target.scalp_point;
  double nearest_mm = 1e300;
  for (double depth = 2; depth <= kDeepest_mm; depth += kStep_mm) {
    const Point<Mri> here(target.scalp_point.mm + depth * z);
    const auto place = brain.nearest(here);
    if (!place.is_outside) return here;
    if (place.distance_mm < nearest_mm) nearest_mm = place.distance_mm, best = here;
  }
  return best;
}

/// Makes a coil pose at a point of the scalp with these directions, to be rested on the head.
guidance::Target standing(const std::string& name, const Vector3d& place_mm, const Vector3d& outwards,
                          const Vector3d& forward, double gap_mm) {
  constexpr double kDepth_mm = 20;  // depth of a first cortex point, which determines the side of the head
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear().col(2) = -outwards.normalized();
  pose.linear().col(1) = (forward - forward.dot(pose.linear().col(2)) * pose.linear().col(2)).normalized();
  pose.linear().col(0) = pose.linear().col(1).cross(pose.linear().col(2));
  pose.translation() = place_mm - gap_mm * pose.linear().col(2);
  guidance::Target target;
  target.name = name;
  target.mri_T_target = RigidTransform<Mri, frames::Target>::fromIsometry(pose);
  target.scalp_point = Point<Mri>(place_mm);
  target.cortex_point = Point<Mri>(place_mm + kDepth_mm * pose.linear().col(2));
  return target;
}

guidance::Target restedOnScalp(const PlannedHead& head, const surface::ClosestPoint& brain,
                               guidance::Target target) {
  target = guidance::restOnHead(target, *head.scalp, head.plate, guidance::Aim::scalp_point);
  target.cortex_point = cortexOnAxis(brain, target);
  return target;
}

void requireBrain(const PlannedHead& head) {
  if (!head.brain)
    throw PlanRefused(PlanRefusal::no_brain, "no brain model", "click on the slice where the target lies");
}

guidance::Target atGridPoint(const PlannedHead& head, const surface::ClosestPoint& brain,
                             const guidance::Target& seed, const guidance::GridPoint& point, bool is_scalp) {
  const std::string name = formatted("%s r%d c%d", seed.name.c_str(), point.row, point.column);
  const double gap_mm = guidance::hairGap_mm(seed);
  if (is_scalp)
    return restedOnScalp(head, brain, standing(name, point.place_mm, point.outwards, point.forward, gap_mm));
  auto target = guidance::planTarget(name, *head.scalp, Point<Mri>(point.place_mm), 0.0, gap_mm);
  const auto carried =
      standing(name, target.scalp_point.mm, -target.mri_T_target.rotation().col(2), point.forward, gap_mm);
  target.mri_T_target = carried.mri_T_target;
  return guidance::restOnHead(target, *head.scalp, head.plate);
}

}  // namespace

guidance::Target targetOverCortex(const PlannedHead& head, const std::string& name,
                                  const Point<Mri>& cortex_point, const CoilWish& wish) {
  const auto tangent = guidance::planTarget(name, *head.scalp, cortex_point, wish.handle_rad, wish.gap_mm);
  return guidance::restOnHead(tangent, *head.scalp, head.plate);
}

guidance::Target targetOnScalp(const PlannedHead& head, const std::string& name,
                               const Point<Mri>& scalp_point, const CoilWish& wish) {
  requireBrain(head);
  const auto skin = surface::ClosestPoint(head.scalp->mesh).nearest(scalp_point);
  const Vector3d out = skin.normal.v;
  const Vector3d forward = std::abs(out.y()) < 0.9 ? Vector3d::UnitY() : Vector3d::UnitZ();
  auto target = standing(name, skin.point.mm, out, forward, wish.gap_mm);
  target = guidance::withHandleAngle(target, *head.scalp, wish.handle_rad);
  return restedOnScalp(head, surface::ClosestPoint(head.brain->mesh), target);
}

std::vector<guidance::Target> gridTargets(const PlannedHead& head, const guidance::Target& seed,
                                          const guidance::GridSpec& grid) {
  requireBrain(head);
  const bool is_scalp = grid.on == guidance::GridOn::scalp;
  const auto& mesh = is_scalp ? head.scalp->mesh : head.brain->mesh;
  const surface::ScalpPaths paths(mesh);
  const surface::ClosestPoint brain(head.brain->mesh);
  const Vector3d seed_mm = (is_scalp ? seed.scalp_point : seed.cortex_point).mm;
  const auto points = guidance::gridRound(paths, mesh, seed_mm, seed.mri_T_target.rotation(), grid);
  std::vector<guidance::Target> targets(points.size());
  parallelFor(points.size(), coreCount(), [&](std::size_t i, std::size_t) {
    if (2 * points[i].row == grid.rows + 1 && 2 * points[i].column == grid.columns + 1) return;  // the seed
    targets[i] = atGridPoint(head, brain, seed, points[i], is_scalp);
    targets[i].grid_place = guidance::GridPlace{seed.name, points[i].row, points[i].column, false};
    targets[i].dose = seed.dose;
  });
  std::vector<guidance::Target> made;
  for (auto& target : targets)
    if (!target.name.empty()) made.push_back(std::move(target));
  return made;
}

guidance::Target mirroredTarget(const PlannedHead& head, const guidance::Target& target,
                                const std::function<Point<Mri>(const Point<Mri>&)>& mirrored) {
  const double handle_rad = guidance::handleAngle(target, *head.scalp).angle_rad;
  auto other = targetOverCortex(head, target.name, cortexNear(head, mirrored(target.cortex_point)),
                                {handle_rad, guidance::hairGap_mm(target)});
  other.note = target.note;
  other.dose = target.dose;
  return other;
}

}  // namespace facenav::steps
