#include <cmath>
#include <cstdio>
#include <random>

#include "facenav/geometry/rotation.h"
#include "script_setting.h"

namespace facenav::room {
namespace {

/// Whole motion of the right camera over the recording: rotation (deg) and shift (mm) in its own frame. The
/// seed draws the sign of a rotation and the direction of a shift.
Vector6d wholeDrift(const ScenarioOptions& options) {
  std::mt19937_64 random(options.seed * 4409 + 11);
  const double sign = random() % 2 ? 1.0 : -1.0;
  Vector6d drift = Vector6d::Zero();
  if (options.drift_about == "pitch") drift[0] = sign * options.drift_deg;
  if (options.drift_about == "yaw") drift[1] = sign * options.drift_deg;
  if (options.drift_about == "roll") drift[2] = sign * options.drift_deg;
  if (options.drift_about != "shift") return drift;
  const auto uniform = [&random] { return double(random() >> 11) * 0x1p-53; };
  const double z = 2.0 * uniform() - 1.0, about = 2.0 * M_PI * uniform(), r = std::sqrt(1.0 - z * z);
  drift.tail<3>() = options.drift_mm * Eigen::Vector3d(r * std::cos(about), r * std::sin(about), z);
  return drift;
}

}  // namespace

MomentOf driftScript(const Setting& setting) {
  const MomentOf treated = treatmentScript(setting);
  const bool has_coil = setting.options.name == "drift";
  return [setting, treated, has_coil, whole = wholeDrift(setting.options)](double frame) {
    Moment moment = treated(frame);
    if (!has_coil) moment.cast.room_T_coil.reset();
    const double part = setting.part(frame);
    moment.cast.right_moved.linear() = expRotation(part * kRadPerDeg * whole.head<3>());
    moment.cast.right_moved.translation() = part * whole.tail<3>();
    char label[64];
    std::snprintf(label, sizeof label, "camera moved by %.3f deg, %.2f mm", part * whole.head<3>().norm(),
                  part * whole.tail<3>().norm());
    moment.label = label;
    return moment;
  };
}

}  // namespace facenav::room
