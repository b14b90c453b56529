#pragma once
// CamerasLearnt: what a session measured about its cameras and stores with the rig for the next session: the
// rolling shutter that a fast coil showed, and that a camera has moved.

#include <array>
#include <optional>
#include <string>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/capture/rig_store.h"
#include "facenav/session/navigation_state.h"

namespace facenav::steps {

struct CamerasLearnt {
  /// Row times of left and right camera, s from one row to the next, if they differ from the rig's.
  std::optional<std::array<double, 2>> row_times_s;
  /// Note that a camera seems to have moved: a fault that withheld every pose to the end, or a small motion
  /// that was corrected. One line; empty: no motion.
  std::string moved;
  bool isEmpty() const { return !row_times_s && moved.empty(); }
};

/// Returns the measured row times (left, right) if they differ relevantly from the rig's.
std::optional<std::array<double, 2>> otherRowTimes(const std::array<double, 2>& measured_s,
                                                   const cameras::StereoRig& rig);

/// Collects a session's results. `last`: its newest state. `rig`: the one it was started with. Row times of
/// cameras that moved or are not in step are wrong and left out.
CamerasLearnt learntOf(const session::NavigationState& last, const cameras::StereoRig& rig);

/// Writes into the store. A rig whose camera seems to have moved becomes unclear, unless a fault is noted
/// already: cameras that are not in step can look moved, and the next opening verifies the rig (rig_start.h).
/// Logs a warning if writing fails.
void keepLearnt(const capture::RigStore& store, const std::string& name, const CamerasLearnt& learnt);

}  // namespace facenav::steps
