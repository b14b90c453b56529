#include "facenav/guidance/coil_plate.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/json_reader.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/geometry/normal_equations.h"
#include "facenav/geometry/rotation.h"
#include "facenav/guidance/handle.h"
#include "plate_geometry.h"

namespace facenav::guidance {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Returns the axes after the smallest rotation that brings z onto `z`.
Matrix3d carried(const Matrix3d& axes, const Vector3d& z) {
  const Eigen::Quaterniond turn = rotationBetween(axes.col(2), z);
  return (turn * Eigen::Quaterniond(axes)).normalized().toRotationMatrix();
}

double angleBetween_rad(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

Error noSkin(const Target& target) {
  return Error("the coil's axis meets no skin", "target " + target.name, "choose another place or direction");
}

class RestingPlate {
 public:
  RestingPlate(const Target& target, const surface::TriangleMesh& skin, const CoilPlate& plate, Aim aim)
      : target_(target),
        plate_(plate),
        axes_(target.mri_T_target.rotation()),
        pivot_mm_(aim == Aim::cortex_point ? target.cortex_point.mm : target.scalp_point.mm),
        under_axis_(partWithin(skin, target.scalp_point.mm, kUnderAxis_mm)),
        under_plate_(partWithin(skin, target.scalp_point.mm, radius_mm(plate) + kTravel_mm)) {}

  Matrix3d findAxes() {
    findTangent();
    const Matrix3d tangent = axes_;
    constexpr int kMostRounds = 30;
    constexpr double kStill_rad = 1e-4;
    for (int round = 0; round < kMostRounds; ++round) {
      const Vector2d slope = leastTilt(tangent.col(2));
      const double part = round < kMostRounds / 2 ? 1.0 : 0.5;  // then smaller: the pose may oscillate
      axes_ = carried(axes_, sloped(part * slope));
      if (slope.norm() < kStill_rad) break;
    }
    return axes_;
  }

  const Vector3d& pivot_mm() const { return pivot_mm_; }
  const surface::TriangleMesh& skin() const { return under_plate_; }

 private:
  double skinHeight() const {
    const auto height = heightOnAxis(under_axis_, axes_, pivot_mm_);
    if (!height) throw noSkin(target_);
    return *height;
  }

  /// Returns the coil's z with these slopes in the present axes.
  Vector3d sloped(const Vector2d& slope) const {
    return (axes_.col(2) + slope.x() * axes_.col(0) + slope.y() * axes_.col(1)).normalized();
  }
  Vector2d slopeOf(const Vector3d& z) const {
    const Vector3d local = axes_.transpose() * z;
    return local.head<2>() / local.z();
  }

  /// Turns the axis until it is the skin's normal where it leaves the head. Keeps the planned axis if the
  /// iteration does not converge nearby: the cortex point then lies near the skin's centre of curvature.
  void findTangent() {
    const Matrix3d planned = axes_;
    constexpr int kMostRounds = 40;
    constexpr double kStill_rad = 1e-4, kSettled_rad = 0.01, kNearby_rad = 35 * kRadPerDeg;
    const double patch_mm = settingsOf<PlateRest>().patch_mm;
    double step_rad = kNearby_rad;
    for (int round = 0; round < kMostRounds && step_rad > kStill_rad; ++round) {
      const auto normal = normalRound(under_axis_, axes_, pivot_mm_, skinHeight(), patch_mm);
      if (!normal) break;
      step_rad = angleBetween_rad(axes_.col(2), -*normal);
      axes_ = carried(axes_, -*normal);
      if (angleBetween_rad(axes_.col(2), planned.col(2)) > kNearby_rad) {
        step_rad = kNearby_rad;
        break;
      }
    }
    if (step_rad > kSettled_rad) axes_ = planned;
  }

  /// Slopes, in the present axes, of the plate with the smallest tilt from the tangent one whose centre is
  /// low enough.
  Vector2d leastTilt(const Vector3d& tangent_z) const {
    constexpr double kAboveLowest_mm = 0.1;
    const auto places = skinUnder(under_plate_, plate_, axes_, pivot_mm_);
    const Vector2d flat = slopeOf(tangent_z);
    const double allowed = skinHeight() + settingsOf<PlateRest>().flat_mm;
    if (heightOfPlate(places, flat) <= allowed) return flat;
    const auto pressed = pressedSlope(places);
    if (!pressed) return flat;  // skin on one side only: the plate stays level and rests on its edge
    const double enough = std::max(allowed, heightOfPlate(places, *pressed) + kAboveLowest_mm);
    double low = 0, high = 1;  // the height falls from `flat` to `pressed`: it is convex between them
    for (int halving = 0; halving < 30; ++halving) {
      const double middle = 0.5 * (low + high);
      (heightOfPlate(places, flat + middle * (*pressed - flat)) > enough ? low : high) = middle;
    }
    return flat + high * (*pressed - flat);
  }

  static constexpr double kTravel_mm = 60;     // largest path of the axis over the skin
  static constexpr double kUnderAxis_mm = 90;  // kTravel_mm plus the patch of the normal

  const Target& target_;
  const CoilPlate& plate_;
  Matrix3d axes_;
  Vector3d pivot_mm_;
  surface::TriangleMesh under_axis_, under_plate_;
};

/// Returns the target with these axes, its axis through `pivot_mm`, lowered onto the skin until the plate
/// touches, then lifted by the gap.
Target lowered(Target target, const Matrix3d& axes, const Vector3d& pivot_mm, double gap_mm,
               const surface::TriangleMesh& skin, const CoilPlate& plate) {
  const auto on_axis = heightOnAxis(skin, axes, pivot_mm);
  const auto top = highest(skin, plate, axes, pivot_mm);
  if (!on_axis || !top) throw noSkin(target);
  const Vector3d z = axes.col(2);
  target.scalp_point = Point<Mri>(pivot_mm - *on_axis * z);
  target.lift_mm = std::max(0.0, *top - *on_axis);
  target.mri_T_target =
      RigidTransform<Mri, frames::Target>(Eigen::Quaterniond(axes), pivot_mm - (*top + gap_mm) * z);
  return target;
}

}  // namespace

CoilPlate figureOfEight() {
  constexpr double kRadius_mm = 52, kBeside_mm = 46.5;
  constexpr int kSteps = 48;
  const double waist_rad = std::acos(-kBeside_mm / kRadius_mm);  // where the discs meet
  CoilPlate plate;
  for (const double side : {1.0, -1.0})
    for (int i = 0; i < kSteps; ++i) {
      const double angle = waist_rad * (2.0 * i / kSteps - 1);
      plate.outline_mm.emplace_back(side * (kBeside_mm + kRadius_mm * std::cos(angle)),
                                    side * kRadius_mm * std::sin(angle));
    }
  return plate;
}

CoilPlate readPlate(const std::filesystem::path& coil_json) {
  const JsonReader json = JsonReader::readFile(coil_json);
  if (!json.has("contact_outline_mm")) return figureOfEight();
  CoilPlate plate;
  const JsonReader outline = json.at("contact_outline_mm");
  for (const JsonReader& corner : outline.elements()) {
    const auto xy = corner.numbers(2);
    if (std::hypot(xy[0], xy[1]) > 300)
      corner.refuse("a corner within 300 mm of the coil's centre was expected");
    plate.outline_mm.emplace_back(xy[0], xy[1]);
  }
  if (plate.outline_mm.size() < 3) outline.refuse("three corners at least were expected");
  if (!isInside(plate.outline_mm, Vector2d::Zero()))
    outline.refuse("the outline was expected to surround the coil's centre [0, 0]");
  return plate;
}

PlateContact contactOf(const Target& target, const surface::ScalpSurface& scalp, const CoilPlate& plate) {
  constexpr double kTouching_mm = 0.05;
  const Matrix3d axes = target.mri_T_target.rotation();
  const double gap_mm = hairGap_mm(target);
  const Vector3d centre = target.mri_T_target.translation_mm() + gap_mm * axes.col(2);
  PlateContact contact;
  const auto on_axis = heightOnAxis(scalp.mesh, axes, centre);
  if (!on_axis) throw noSkin(target);
  contact.lift_mm = -*on_axis;
  if (const auto normal = normalRound(scalp.mesh, axes, centre, *on_axis, settingsOf<PlateRest>().patch_mm))
    contact.tilt_rad = angleBetween_rad(axes.col(2), -*normal);
  contact.through_mm = std::max(0.0, highest(scalp.mesh, plate, axes, centre).value_or(0.0));
  for (const OverPlate& p : skinUnder(scalp.mesh, plate, axes, centre))
    if (std::abs(p.z()) <= kTouching_mm)
      contact.touching.emplace_back(centre + axes * Vector3d(p.x(), p.y(), -p.z()));
  return contact;
}

Target restOnHead(const Target& target, const surface::ScalpSurface& scalp, const CoilPlate& plate, Aim aim) {
  if (scalp.mesh.triangles.empty()) throw noSkin(target);
  const double gap_mm = hairGap_mm(target);
  const HandleAngle handle = handleAngle(target, scalp);
  RestingPlate resting(target, scalp.mesh, plate, aim);
  const Matrix3d axes = resting.findAxes();
  Target rested = lowered(target, axes, resting.pivot_mm(), gap_mm, resting.skin(), plate);
  if (handleAngle(rested, scalp).reference != handle.reference) return rested;  // not turned
  const Matrix3d turned = withHandleAngle(rested, scalp, handle.angle_rad).mri_T_target.rotation();
  return lowered(rested, turned, resting.pivot_mm(), gap_mm, resting.skin(), plate);
}

Target settleOnHead(const Target& target, const surface::ScalpSurface& scalp, const CoilPlate& plate) {
  constexpr double kSame_mm = 0.1;
  const Target settled = lowered(target, target.mri_T_target.rotation(), target.mri_T_target.translation_mm(),
                                 hairGap_mm(target), scalp.mesh, plate);
  const double allowed_mm = std::max(settingsOf<PlateRest>().flat_mm, target.lift_mm + kSame_mm);
  return settled.lift_mm <= allowed_mm ? settled : restOnHead(target, scalp, plate);
}

Target movedOnHead(const Target& target, const surface::ScalpSurface& scalp, const CoilPlate& plate,
                   double x_mm, double y_mm) {
  const Matrix3d old_axes = target.mri_T_target.rotation();
  const Vector3d below_mm = target.cortex_point.mm - target.mri_T_target.translation_mm() -
                            centreGap_mm(target) * old_axes.col(2);  // cortex from the skin on the axis
  Target moved = movedAlongScalp(target, scalp, x_mm, y_mm);
  // The present axis is the start, not the normal there, which is another one on rough skin.
  const Vector3d place_mm = moved.scalp_point.mm - hairGap_mm(target) * old_axes.col(2);
  moved.mri_T_target = RigidTransform<Mri, frames::Target>(Eigen::Quaterniond(old_axes), place_mm);
  Target rested = restOnHead(moved, scalp, plate, Aim::scalp_point);
  const Matrix3d axes = carried(old_axes, rested.mri_T_target.rotation().col(2));
  rested = lowered(rested, axes, rested.mri_T_target.translation_mm(), hairGap_mm(rested), scalp.mesh, plate);
  rested.cortex_point = Point<Mri>(rested.scalp_point.mm + axes * old_axes.transpose() * below_mm);
  return rested;
}

}  // namespace facenav::guidance
