#pragma once
// Pose of the coil at a pulse: the poses of the frames before and after it, interpolated to its own time, and
// compared with the target as it was then. Pure functions.

#include <optional>
#include <string>

#include "facenav/casefile/pulse.h"
#include "facenav/links/pulse_trigger.h"
#include "facenav/registration/scalp_field.h"
#include "facenav/session/navigation_state.h"

namespace facenav::session {

using links::PulseTrigger;

/// The part of a frame's state that a pulse needs; without its images.
struct PosedFrame {
  std::int64_t frame = -1;
  Timestamp captured, taken;  // source's clock, steady clock
  std::optional<RigidTransform<Camera, Mri>> camera_T_mri;
  std::optional<RigidTransform<Camera, Coil>> camera_T_coil;
  std::shared_ptr<const ChosenTarget> chosen;
  guidance::Tolerance tolerance;
  std::string loss;                                // what is lost: "face covered"; empty if nothing is
  std::string coil;                                // name of the tracked coil
  std::optional<guidance::LiveSurface> live = {};  // beside the coil
  std::shared_ptr<const PosedFrame> second = {};   // the same with the second coil; null: there is none
};
PosedFrame posedFrame(const NavigationState& state);

/// Largest time between two frames for interpolation.
constexpr double kLongestBetweenFrames_s = 0.25;
/// Longest wait for the frame after a pulse: a frame's interval, the exposure, and the latency of cameras and
/// tracking. Without that frame the pulse's pose is lost.
constexpr double kLongestWait_s = 0.5;

/// Limit of a pulse on target: gap to the skin beyond the planned one (centreGap_mm; 3 mm cost 12 % of the
/// field, at 4 % a mm). The alignment's error is limited too (kMostErrorBound_mm).
constexpr double kMostGapBeyondPlan_mm = 3.0;

/// Returns the part of a frame that belongs to a pulse of this coil; nothing: that coil is not tracked. An
/// empty name is the only coil's; with two coils it is none's, because it is not known which gave the pulse.
std::optional<PosedFrame> ofCoil(const std::optional<PosedFrame>& frame, const std::string& coil);

/// Computes the pulse, without its number. `before`: the last frame taken at or before the pulse, `after`:
/// the first one later; nothing if there is none. Lost if either frame is missing or has lost head or coil,
/// or if another coil was chosen between them.
/// Tolerances apply as they are, without the hysteresis of guidance. The target is that of `before`. The gap
/// is the distance of the contact face's centre from `scalp`; unknown for null, or for skin beyond the scan.
casefile::Pulse pulseBetween(const PulseTrigger& trigger, const std::optional<PosedFrame>& before,
                             const std::optional<PosedFrame>& after,
                             const registration::ScalpField* scalp = nullptr);

}  // namespace facenav::session
