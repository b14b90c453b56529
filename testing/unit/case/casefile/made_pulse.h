#pragma once
// A pulse with every field set, for tests.

#include "facenav/casefile/pulse.h"

namespace facenav::casefile {

inline RigidTransform<Camera, Mri> madeCamera_T_mri() {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(2.0, Eigen::Vector3d(1, 2, 3).normalized())), {10, -20, 600}};
}

/// Makes a pulse on a target; the coil is `off_mm` away along the target's x.
inline Pulse madePulse(int number, double off_mm = 0.5) {
  Pulse pulse;
  pulse.number = number;
  pulse.t_s = 10.0 + 0.1 * number;
  pulse.steady_s = 5000.0 + 0.1 * number;
  pulse.utc = "2026-11-23T14:05:09.123Z";
  pulse.source = "keyboard";
  pulse.target =
      guidance::Target{"M1, \"hand\"",
                       {Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitY())), {-40, -10, 60}},
                       {-35, -10, 45},
                       {-40, -10, 60},
                       {}};
  const RigidTransform<frames::Target, Coil> target_T_coil(Eigen::Quaterniond::Identity(), {off_mm, 0, 0});
  pulse.camera_T_mri = madeCamera_T_mri();
  pulse.camera_T_coil = madeCamera_T_mri() * pulse.target->mri_T_target * target_T_coil;
  pulse.frames = {7 * number, 7 * number + 1};
  pulse.fraction = 0.25;
  pulse.offset = PulseOffset{off_mm, off_mm, 0.0, 0.0, 0.0};
  pulse.status = off_mm <= 2.0 ? PulseStatus::on_target : PulseStatus::outside;
  if (off_mm > 2.0) pulse.reason = "beside the target";
  pulse.predicted_error_mm = 0.8;
  pulse.intensity_pct = 55.0;
  return pulse;
}

inline Pulse madeLostPulse(int number) {
  Pulse pulse;
  pulse.number = number;
  pulse.t_s = 10.0 + 0.1 * number;
  pulse.steady_s = 5000.0 + 0.1 * number;
  pulse.utc = "2026-11-23T14:05:10.000Z";
  pulse.source = "keyboard";
  pulse.reason = "face covered";
  return pulse;
}

}  // namespace facenav::casefile
