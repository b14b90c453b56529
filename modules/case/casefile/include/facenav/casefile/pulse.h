#pragma once
// Pulse: one TMS pulse of a session, as it was kept at its own moment: time on both clocks, poses of head and
// coil, the target as it was then, what was off, and why. pulse_file.h keeps it, session_pulses.h reads it.

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "facenav/geometry/rigid_transform.h"
#include "facenav/guidance/target.h"

namespace facenav::casefile {

/// lost: head or coil had no pose, so that nothing is known of where the coil was.
enum class PulseStatus { on_target, outside, lost };
/// "on_target", "outside", "lost".
std::string toString(PulseStatus status);
/// Throws Error for another word.
PulseStatus pulseStatusFrom(const std::string& word);

/// Of the coil against the target, as in guidance.csv.
struct PulseOffset {
  double distance_mm = 0, lateral_mm = 0, depth_mm = 0, tilt_deg = 0, twist_deg = 0;
};

/// Absent: not known.
struct Pulse {
  int number = 0;             // from 1, in the order of arrival
  std::optional<double> t_s;  // the clock of poses.csv
  double steady_s = 0;        // the machine's monotonic clock
  std::string utc;            // 2026-11-23T14:05:09.123Z
  std::string source;         // "keyboard", ..
  PulseStatus status = PulseStatus::lost;
  std::string reason;                      // in words: what was lost, or outside the tolerance
  std::string coil;                        // name of the coil that was followed; empty: not known
  std::optional<guidance::Target> target;  // a copy, without its note
  std::optional<RigidTransform<Camera, Mri>> camera_T_mri;
  std::optional<RigidTransform<Camera, Coil>> camera_T_coil;
  std::optional<std::array<std::int64_t, 2>> frames;  // the frames before and after the pulse
  double fraction = 0;                                // of the way between them
  std::optional<PulseOffset> offset;
  std::optional<double> gap_mm, predicted_error_mm, intensity_pct, e_target_v_per_m, mep_uv, latency_ms;
  std::optional<double>
      gap_stereo_mm;  // to the live surface (skin or hair) that the cameras see beside the coil

  /// Absent unless both poses are known.
  std::optional<RigidTransform<Mri, Coil>> mri_T_coil() const;
};

/// One line of pulses.jsonl, with its newline.
std::string toJsonLine(const Pulse& pulse);

}  // namespace facenav::casefile
