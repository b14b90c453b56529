#pragma once
// Pulse: one TMS pulse of a session, as recorded at its own time: both clocks, poses of head and coil, the
// target as it was then, what was outside the tolerance, and why. pulse_file.h writes it, session_pulses.h
// reads it.

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "facenav/geometry/rigid_transform.h"
#include "facenav/guidance/target.h"

namespace facenav::casefile {

/// Verdict of a pulse. lost: head or coil had no pose, so the coil's position is unknown.
enum class PulseStatus { on_target, outside, lost };
/// Returns "on_target", "outside" or "lost".
std::string toString(PulseStatus status);
/// Parses the word. Throws Error for any other.
PulseStatus pulseStatusFrom(const std::string& word);

/// Offset of the coil from the target, as in guidance.csv.
struct PulseOffset {
  double distance_mm = 0, lateral_mm = 0, depth_mm = 0, tilt_deg = 0, twist_deg = 0;
};

/// Electric field that a pulse's pose gives on the cortex, by a model of the head (pulse_field_file.h). |E|
/// in V/m at a rate of the current of 1 A/us.
struct PulseField {
  std::string coil;                     // whose field: figure8-70, or the name of a coil's file
  int tier = 0;                         // model of the head (resources/doc/field.md)
  std::optional<double> at_target;      // nothing: the pulse had no target
  double peak = 0;                      // maximum on the cortex
  Point<Mri> peak_place;                // where it is
  std::optional<double> rate_A_per_us;  // of the pulse; nothing: not known
};

/// One pulse. Absent values are unknown.
struct Pulse {
  int number = 0;             // from 1, in the order of arrival
  std::optional<double> t_s;  // the clock of poses.csv
  double steady_s = 0;        // the machine's monotonic clock
  std::string utc;            // 2026-11-23T14:05:09.123Z
  std::string source;         // "keyboard", ..
  PulseStatus status = PulseStatus::lost;
  std::string reason;                      // in words: what was lost, or outside the tolerance
  std::string coil;                        // name of the coil that was tracked; empty: unknown
  std::optional<guidance::Target> target;  // a copy, without its note
  std::optional<RigidTransform<Camera, Mri>> camera_T_mri;
  std::optional<RigidTransform<Camera, Coil>> camera_T_coil;
  std::optional<std::array<std::int64_t, 2>> frames;  // the frames before and after the pulse
  double fraction = 0;                                // position of the pulse between them, 0..1
  std::optional<PulseOffset> offset;
  std::optional<double> gap_mm, predicted_error_mm, intensity_pct, e_target_v_per_m, mep_uv, latency_ms;
  std::optional<double> gap_stereo_mm;  // to the live surface (skin or hair) beside the coil
  /// Bound of the alignment's error at the target that 95 of 100 alignments keep. predicted_error_mm is its
  /// standard error.
  std::optional<double> error_bound_mm;
  bool is_in_pause = false;         // given while the session was paused
  std::optional<PulseField> field;  // computed from the pose; not part of the pulse's own line

  /// Pose of the coil in the MRI; absent unless both poses are known.
  std::optional<RigidTransform<Mri, Coil>> mri_T_coil() const;
};

/// Formats one line of pulses.jsonl, with its newline.
std::string toJsonLine(const Pulse& pulse);

}  // namespace facenav::casefile
