#include "facenav/plan/best_pose.h"

#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/parallel_for.h"
#include "facenav/geometry/rotation.h"

namespace facenav::steps {
namespace {

constexpr double kGridReach_mm = 10, kGridStep_mm = 5;
constexpr int kAngles = 36;
constexpr double kEqual = 1e-4;

/// What is maximised, for one pose.
class Aimed {
 public:
  Aimed(const HeadField& head, const efield::CoilDipoles& coil, const guidance::Target& target, FieldAim aim,
        const Eigen::Vector3d& normal)
      : head_(head), coil_(coil), point_(target.cortex_point.mm), aim_(aim), normal_(normal) {}
  double at(const guidance::Target& target) const {
    const Eigen::Vector3d field = head_.at(coil_, coilPoseOf(target), point_).col(0);
    return aim_ == FieldAim::strength ? field.norm() : std::abs(field.dot(normal_));
  }

 private:
  const HeadField& head_;
  const efield::CoilDipoles& coil_;
  Eigen::Matrix3Xd point_;
  FieldAim aim_;
  Eigen::Vector3d normal_;
};

/// Best angle at one place.
BestPose bestAngle(const Aimed& aimed, const guidance::Target& there) {
  BestPose best;
  for (int a = 0; a < kAngles; ++a) {
    const double angle_deg = 360.0 / kAngles * (a % 2 ? (a + 1) / 2 : -a / 2);  // 0, 10, -10, 20, ..
    const double value = aimed.at(turned(there, angle_deg * kRadPerDeg));
    if (value <= best.best * (1 + kEqual)) continue;
    best.best = value;
    best.turned_deg = angle_deg;
  }
  best.target = there;
  return best;
}

}  // namespace

BestPose bestPose(const HeadField& head, const FieldSurfaces& surfaces, const PlannedHead& planned,
                  const efield::CoilDipoles& coil, const guidance::Target& target, FieldAim aim) {
  const Aimed aimed(head, coil, target, aim, cortexNormal(surfaces, target).normal);
  std::vector<Eigen::Vector2d> steps;
  for (double y_mm = -kGridReach_mm; y_mm <= kGridReach_mm; y_mm += kGridStep_mm)
    for (double x_mm = -kGridReach_mm; x_mm <= kGridReach_mm; x_mm += kGridStep_mm)
      steps.emplace_back(x_mm, y_mm);
  std::vector<BestPose> found(steps.size());
  parallelFor(steps.size(), coreCount(), [&](std::size_t i, std::size_t) {
    const bool is_planned = steps[i].norm() < 1e-9;
    try {
      const auto there = is_planned ? target
                                    : guidance::movedOnHead(target, *planned.scalp, planned.plate,
                                                            steps[i].x(), steps[i].y());
      found[i] = bestAngle(aimed, there);
    } catch (const Error&) {
      // The scalp ends there: no pose at this place.
    }
    found[i].x_mm = steps[i].x();
    found[i].y_mm = steps[i].y();
  });
  BestPose best;  // x_mm and y_mm are those of the grid until its pose is known
  for (const auto& one : found) {
    if (one.best <= 0) continue;
    best.poses += kAngles;
    const bool is_nearer = std::hypot(one.x_mm, one.y_mm) < std::hypot(best.x_mm, best.y_mm);
    const double margin = is_nearer ? 1 - kEqual : 1 + kEqual;
    if (best.best > 0 && one.best < best.best * margin) continue;
    const int poses = best.poses;
    best = one;
    best.poses = poses;
  }
  const double planned_value = aimed.at(target);
  if (best.turned_deg != 0 || best.x_mm != 0 || best.y_mm != 0)
    best.target = guidance::settleOnHead(turned(best.target, best.turned_deg * kRadPerDeg), *planned.scalp,
                                         planned.plate);
  best.target.cortex_point = target.cortex_point;
  best.best = aimed.at(best.target);
  if (!(best.best > planned_value)) {  // the planned pose need not rest on the head, and may be stronger
    const int poses = best.poses;
    best = BestPose{target};
    best.best = planned_value;
    best.poses = poses;
  }
  const auto& from = target.mri_T_target;
  const Eigen::Vector3d moved_mm =
      from.rotation().transpose() * (best.target.mri_T_target.translation_mm() - from.translation_mm());
  best.x_mm = moved_mm.x();
  best.y_mm = moved_mm.y();
  best.planned = planned_value;
  return best;
}

}  // namespace facenav::steps
