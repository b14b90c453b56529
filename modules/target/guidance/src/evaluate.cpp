#include <Eigen/Geometry>
#include <cmath>

#include "facenav/guidance/guidance.h"
#include "facenav/guidance/instruction.h"

namespace facenav::guidance {
namespace {

/// Angle about z of the swing-twist decomposition of `rotation`, -pi..pi.
double twistAboutZ_rad(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond q(rotation);
  if (std::hypot(q.w(), q.z()) < 1e-9) return 0.0;
  double twist_rad = 2.0 * std::atan2(q.z(), q.w());
  if (twist_rad > M_PI) twist_rad -= 2.0 * M_PI;
  if (twist_rad <= -M_PI) twist_rad += 2.0 * M_PI;
  return twist_rad;
}

/// Smallest rotation (about an axis perpendicular to z) that aligns the coil's z with `z_target`, as its x
/// and y components.
Eigen::Vector2d tiltToward_rad(const Eigen::Vector3d& z_target) {
  const double sine = std::hypot(z_target.x(), z_target.y());
  const double tilt_rad = std::atan2(sine, z_target.z());
  if (sine < 1e-12) return {tilt_rad, 0.0};
  return Eigen::Vector2d(-z_target.y(), z_target.x()) * (tilt_rad / sine);
}

GuidanceState lost(LostReason reason, bool is_head) {
  GuidanceState state;
  state.reason = reason;
  state.instruction = lossInWords(reason, is_head);
  return state;
}

}  // namespace

std::string toString(State state) {
  switch (state) {
    case State::on_target:
      return "on_target";
    case State::adjust:
      return "adjust";
    case State::lost:
      return "lost";
  }
  FACENAV_EXPECT(false, "unknown guidance state");
}

GuidanceValues evaluate(const Target& target, const RigidTransform<Mri, Coil>& mri_T_coil) {
  const RigidTransform<frames::Target, Coil> target_T_coil = target.mri_T_target.inverse() * mri_T_coil;
  const RigidTransform<Coil, frames::Target> coil_T_target = target_T_coil.inverse();
  const Eigen::Vector3d centre_mm = target_T_coil.translation_mm();
  const Eigen::Vector3d z_coil = target_T_coil.rotation().col(2);
  const Eigen::Vector3d cortex_in_coil_mm = (mri_T_coil.inverse() * target.cortex_point).mm;
  GuidanceValues values{};
  values.distance_mm = centre_mm.norm();
  values.lateral_mm = centre_mm.head<2>().norm();
  values.depth_mm = centre_mm.z();
  values.tilt_rad = std::atan2(z_coil.head<2>().norm(), z_coil.z());
  values.twist_rad = twistAboutZ_rad(target_T_coil.rotation());
  values.beam_miss_mm = cortex_in_coil_mm.head<2>().norm();
  values.lateral_in_target_mm = centre_mm.head<2>();
  values.lateral_in_coil_mm = coil_T_target.translation_mm().head<2>();
  values.tilt_in_coil_rad = tiltToward_rad(coil_T_target.rotation().col(2));
  return values;
}

GuidanceState evaluate(const Target& target, const Tracked<RigidTransform<Camera, Mri>>& camera_T_mri,
                       const Tracked<RigidTransform<Camera, Coil>>& camera_T_coil, const Tolerance& tolerance,
                       double predicted_error_mm) {
  return evaluate(target, camera_T_mri, camera_T_coil, tolerance, predicted_error_mm, GuidanceState{});
}

GuidanceState evaluate(const Target& target, const Tracked<RigidTransform<Camera, Mri>>& camera_T_mri,
                       const Tracked<RigidTransform<Camera, Coil>>& camera_T_coil, const Tolerance& tolerance,
                       double predicted_error_mm, const GuidanceState& previous,
                       const Hysteresis& hysteresis) {
  if (!camera_T_mri) return lost(camera_T_mri.reason(), true);
  if (!camera_T_coil) return lost(camera_T_coil.reason(), false);
  GuidanceState state;
  state.values = evaluate(target, camera_T_mri->inverse() * *camera_T_coil);
  const Instruction instruction = instruct(target, *state.values, tolerance, previous.action, hysteresis);
  state.action = instruction.action;
  state.instruction = instruction.words;
  state.state = instruction.action == Action::hold ? State::on_target : State::adjust;
  state.predicted_error_mm = predicted_error_mm;
  return state;
}

}  // namespace facenav::guidance
