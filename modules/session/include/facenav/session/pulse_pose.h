#pragma once
// Where the coil was at a pulse: the poses of the frames before and after it, interpolated to its own time,
// and judged against the target as it was then. Pure functions.

#include <chrono>
#include <optional>
#include <string>

#include "facenav/casefile/pulse.h"
#include "facenav/session/navigation_state.h"

namespace facenav::session {

/// A pulse as it arrives from a key, a pedal, a line.
struct PulseTrigger {
  std::string source = "keyboard";
  Timestamp at = Timestamp::now();  // steady clock
  std::chrono::system_clock::time_point utc = std::chrono::system_clock::now();
  /// A second trigger of the same source within this time is a bounce, not a pulse. It must be shorter than
  /// the time between the pulses of a train.
  double dead_time_s = 0.15;
  std::optional<double> intensity_pct = {};
};

/// What a pulse needs of a frame; without its images.
struct PosedFrame {
  std::int64_t frame = -1;
  Timestamp captured, taken;  // source's clock, steady clock
  std::optional<RigidTransform<Camera, Mri>> camera_T_mri;
  std::optional<RigidTransform<Camera, Coil>> camera_T_coil;
  std::shared_ptr<const ChosenTarget> chosen;
  guidance::Tolerance tolerance;
  std::string loss;  // what is lost, in words: "face covered"; empty if nothing is
};
PosedFrame posedFrame(const NavigationState& state);

/// Frames further apart say too little of the moment between them.
constexpr double kLongestBetweenFrames_s = 0.25;
/// The frame after a pulse comes within this time, or its pose is lost.
constexpr double kLongestWait_s = 0.1;

/// The pulse without its number. `before`: the last frame taken at or before the pulse, `after`: the first
/// one later; nothing where there is none. Lost if either frame is missing or has lost head or coil.
/// Tolerances hold as they are, without the hysteresis of guidance. The target is that of `before`.
casefile::Pulse pulseBetween(const PulseTrigger& trigger, const std::optional<PosedFrame>& before,
                             const std::optional<PosedFrame>& after);

}  // namespace facenav::session
