#pragma once
// Where the coil was at a pulse: the poses of the frames before and after it, interpolated to its own time,
// and judged against the target as it was then. Pure functions.

#include <optional>
#include <string>

#include "facenav/casefile/pulse.h"
#include "facenav/links/pulse_trigger.h"
#include "facenav/registration/scalp_field.h"
#include "facenav/session/navigation_state.h"

namespace facenav::session {

using links::PulseTrigger;

/// What a pulse needs of a frame; without its images.
struct PosedFrame {
  std::int64_t frame = -1;
  Timestamp captured, taken;  // source's clock, steady clock
  std::optional<RigidTransform<Camera, Mri>> camera_T_mri;
  std::optional<RigidTransform<Camera, Coil>> camera_T_coil;
  std::shared_ptr<const ChosenTarget> chosen;
  guidance::Tolerance tolerance;
  std::string loss;  // what is lost, in words: "face covered"; empty if nothing is
  std::string coil;  // name of the coil that was followed
  std::optional<guidance::LiveSurface> live = {};  // beside the coil
};
PosedFrame posedFrame(const NavigationState& state);

/// Frames further apart say too little of the moment between them.
constexpr double kLongestBetweenFrames_s = 0.25;
/// The frame after a pulse arrives within this time, or its pose is lost: a frame's interval, the exposure,
/// and the latency of cameras and tracking. A frame that arrives ends the wait.
constexpr double kLongestWait_s = 0.5;

/// A pulse is outside where the gap to the skin exceeds the planned one (centreGap_mm) by more (12 % of the
/// field, at 4 % a mm), and where the alignment's predicted error at the target is larger: as large as the
/// lateral tolerance, it cannot be told whether the coil was on target.
constexpr double kMostGapBeyondPlan_mm = 3.0, kMostPredictedError_mm = 2.0;

/// The pulse without its number. `before`: the last frame taken at or before the pulse, `after`: the first
/// one later; nothing where there is none. Lost if either frame is missing or has lost head or coil, and
/// where another coil was chosen between them.
/// Tolerances hold as they are, without the hysteresis of guidance. The target is that of `before`. The gap
/// is the distance of the contact face's centre from `scalp`; null, or skin beyond the scan: not known.
casefile::Pulse pulseBetween(const PulseTrigger& trigger, const std::optional<PosedFrame>& before,
                             const std::optional<PosedFrame>& after,
                             const registration::ScalpField* scalp = nullptr);

}  // namespace facenav::session
