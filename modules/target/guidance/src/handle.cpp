#include "facenav/guidance/handle.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/geometry/normal_equations.h"
#include "facenav/guidance/coil_plate.h"
#include "plate_geometry.h"
#include "tangent_directions.h"

namespace facenav::guidance {
namespace {

/// Limit above which the projection of anterior onto the coil's plane is shorter than 0.436 = sqrt(1 -
/// 0.9^2).
constexpr double kMostAlongAnterior = 0.9;

/// x of the head's mid-sagittal plane: the middle of the scalp's extent (the world origin may lie anywhere).
double midline_x_mm(const surface::TriangleMesh& mesh) {
  const auto [low, high] = std::minmax_element(mesh.vertices_mm.begin(), mesh.vertices_mm.end(),
                                               [](const auto& a, const auto& b) { return a.x() < b.x(); });
  return 0.5 * (low->x() + high->x());
}

}  // namespace

TangentDirections tangentDirections(const surface::TriangleMesh& scalp, const Eigen::Vector3d& z,
                                    const Point<Mri>& cortex_point) {
  TangentDirections directions;
  const bool has_anterior = std::abs(z.y()) <= kMostAlongAnterior;
  directions.reference = has_anterior ? HandleReference::anterior : HandleReference::superior;
  const Eigen::Vector3d wanted = has_anterior ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
  directions.forward = (wanted - wanted.dot(z) * z).normalized();
  directions.medial = z.cross(directions.forward);
  // Over the vertex, x determines which direction is medial. On the side of the head, where x is nearly along
  // z, medial is up.
  const double sign = midline_x_mm(scalp) > cortex_point.mm.x() ? 1.0 : -1.0;
  if (directions.medial.dot(Eigen::Vector3d(sign, 0, has_anterior ? 1 : 0)) < 0)
    directions.medial = -directions.medial;
  return directions;
}

HandleAngle handleAngle(const Target& target, const surface::ScalpSurface& scalp) {
  const Eigen::Matrix3d axes = target.mri_T_target.rotation();
  const auto directions = tangentDirections(scalp.mesh, axes.col(2), target.cortex_point);
  return {std::atan2(axes.col(1).dot(directions.medial), axes.col(1).dot(directions.forward)),
          directions.reference};
}

double centreGap_mm(const Target& target) {
  return (target.scalp_point.mm - target.mri_T_target.translation_mm())
      .dot(target.mri_T_target.rotation().col(2));
}

double hairGap_mm(const Target& target) { return centreGap_mm(target) - target.lift_mm; }

double cortexDepth_mm(const Target& target) {
  return (target.cortex_point.mm - target.scalp_point.mm).dot(target.mri_T_target.rotation().col(2));
}

Target withHandleAngle(const Target& target, const surface::ScalpSurface& scalp, double angle_rad) {
  if (!(std::abs(angle_rad) <= kMostHandle_rad))
    throw Error("a handle angle lies between -180 and 180 degrees", {}, "0 points straight back");
  Eigen::Matrix3d axes = target.mri_T_target.rotation();
  const auto directions = tangentDirections(scalp.mesh, axes.col(2), target.cortex_point);
  axes.col(1) = std::cos(angle_rad) * directions.forward + std::sin(angle_rad) * directions.medial;
  axes.col(0) = axes.col(1).cross(axes.col(2));
  Target turned = target;
  turned.mri_T_target =
      RigidTransform<Mri, frames::Target>(Eigen::Quaterniond(axes), target.mri_T_target.translation_mm());
  return turned;
}

Target withHairGap(const Target& target, double gap_mm) {
  if (!(gap_mm >= 0 && gap_mm <= kMostGap_mm))
    throw Error("a gap for hair lies between 0 and " + std::to_string(int(kMostGap_mm)) + " mm", {},
                "measure it on the patient");
  const Eigen::Vector3d z = target.mri_T_target.rotation().col(2);
  const Eigen::Vector3d place_mm = target.mri_T_target.translation_mm() + (hairGap_mm(target) - gap_mm) * z;
  Target moved = target;
  moved.mri_T_target = RigidTransform<Mri, frames::Target>(target.mri_T_target.quaternion(), place_mm);
  return moved;
}

Target movedAlongScalp(const Target& target, const surface::ScalpSurface& scalp, double x_mm, double y_mm) {
  constexpr double kStep_mm = 10, kPastStep_mm = 30;
  const Eigen::Matrix3d planned = target.mri_T_target.rotation();
  const Eigen::Vector3d from_mm =
      target.mri_T_target.translation_mm() + centreGap_mm(target) * planned.col(2);
  const double way_mm = std::hypot(x_mm, y_mm);
  const auto skin = partWithin(scalp.mesh, from_mm, way_mm + kPastStep_mm);
  const int steps = std::max(1, int(std::ceil(way_mm / kStep_mm)));
  Eigen::Matrix3d axes = planned;
  Eigen::Vector3d normal;
  const auto ontoSkin = [&](const Eigen::Vector3d& over_mm) -> Eigen::Vector3d {
    const auto height_mm = heightOnAxis(skin, axes, over_mm);
    const auto found = height_mm
                           ? normalRound(skin, axes, over_mm, *height_mm, settingsOf<PlateRest>().patch_mm)
                           : std::nullopt;
    if (!found) throw Error("the scalp ends there", "target " + target.name, "move it less far");
    normal = *found;
    return over_mm - *height_mm * axes.col(2);
  };
  Eigen::Vector3d place_mm = ontoSkin(from_mm);
  for (int i = 0; i < steps; ++i) {
    const Eigen::Vector3d before = normal;
    place_mm = ontoSkin(place_mm + axes * Eigen::Vector3d(x_mm, y_mm, 0) / steps);
    axes = rotationBetween(before, normal).toRotationMatrix() * axes;  // a tilt stays
  }
  Target moved = target;
  moved.scalp_point = Point<Mri>(place_mm);
  moved.cortex_point = Point<Mri>(place_mm + axes * planned.transpose() * (target.cortex_point.mm - from_mm));
  moved.lift_mm = 0;
  moved.mri_T_target = RigidTransform<Mri, frames::Target>(Eigen::Quaterniond(axes).normalized(),
                                                           place_mm - hairGap_mm(target) * axes.col(2));
  return moved;
}

}  // namespace facenav::guidance
