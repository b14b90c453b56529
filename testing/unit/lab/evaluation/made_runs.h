#pragma once
// Runs with known errors, for tests of figures and verdicts.

#include "facenav/evaluation/run_record.h"

namespace facenav::evaluation::made {

inline Eigen::Isometry3d shifted(double x_mm, double y_mm = 0.0, double z_mm = 0.0) {
  return Eigen::Isometry3d(Eigen::Translation3d(x_mm, y_mm, z_mm));
}

/// Pose turned about an axis through the origin.
inline Eigen::Isometry3d turned(double deg, const Eigen::Vector3d& axis) {
  return Eigen::Isometry3d(Eigen::AngleAxisd(deg * M_PI / 180, axis));
}

/// Run of `frames` frames of a head at z = 600 mm, tracked without error. The target is Mri's origin.
inline RunRecord perfectRun(const std::string& scenario, int frames) {
  RunRecord run;
  run.scenario = scenario;
  run.head = "egg";
  run.rig = "one";
  run.true_reference = shifted(0, 0, 600);
  run.alignment.emplace();
  run.alignment->estimated = run.alignment->truth = run.true_reference;
  for (int i = 0; i < frames; ++i) {
    FrameRecord frame;
    frame.frame = i;
    frame.t_s = i / 60.0;
    frame.truth.head = run.true_reference;
    frame.head_motion = Eigen::Isometry3d::Identity();
    run.frames.push_back(frame);
  }
  return run;
}

/// Adds the coil, tracked without error, `at_mm` in Camera; its z points along `into` (to the coil's front).
inline void addCoil(RunRecord& run, const Eigen::Isometry3d& camera_T_marker) {
  for (auto& frame : run.frames) frame.truth.marker = frame.marker = camera_T_marker;
}

}  // namespace facenav::evaluation::made
