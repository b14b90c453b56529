#pragma once
// CamerasLearnt: what a session found out about its cameras, and what is kept of it with the rig, so that the
// next session starts with it: the rolling shutter that a fast coil showed, and that a camera has moved.

#include <array>
#include <optional>
#include <string>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/capture/rig_store.h"
#include "facenav/session/navigation_state.h"

namespace facenav::steps {

struct CamerasLearnt {
  /// Left and right, s from one row to the row below, where they differ from what the rig states.
  std::optional<std::array<double, 2>> row_times_s;
  /// That a camera seems to have moved: a fault that withheld every pose to the end, or a small motion that
  /// was corrected. One line; empty: nothing of it.
  std::string moved;
  bool isEmpty() const { return !row_times_s && moved.empty(); }
};

/// Measured row times (left, right) where they differ from what the rig states by more than matters.
std::optional<std::array<double, 2>> otherRowTimes(const std::array<double, 2>& measured_s,
                                                   const cameras::StereoRig& rig);

/// `last`: newest state of a session. `rig`: that it was started with. Row times are not kept from cameras
/// that moved or are not in step: they falsify them.
CamerasLearnt learntOf(const session::NavigationState& last, const cameras::StereoRig& rig);

/// Into the store. A rig whose camera seems to have moved becomes unclear, unless a fault is noted already:
/// cameras that are not in step can look like it, and the next opening verifies it (rig_start.h). What cannot
/// be written is a warning in the log.
void keepLearnt(const capture::RigStore& store, const std::string& name, const CamerasLearnt& learnt);

}  // namespace facenav::steps
