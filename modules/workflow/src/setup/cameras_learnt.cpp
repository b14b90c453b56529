#include "facenav/workflow/cameras_learnt.h"

#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/workflow/verify_rig.h"

namespace facenav::workflow {
namespace {

constexpr double kSameReadout_s =
    0.5e-3;  // of a whole picture: less moves a coil of 1 m/s by 0.25 mm at most

bool haveMoved(head_tracking::LossDetail detail) {
  using head_tracking::LossDetail;
  return detail == LossDetail::cameras_moved || detail == LossDetail::other_rig ||
         detail == LossDetail::swapped;
}

bool isFaulty(const capture::NamedRig& rig) {
  for (const auto state : {RigState::moved, RigState::other_cameras, RigState::swapped})
    if (rig.last_check && rig.last_check->state == toString(state)) return true;
  return false;
}

}  // namespace

std::optional<std::array<double, 2>> otherRowTimes(const std::array<double, 2>& measured_s,
                                                   const cameras::StereoRig& rig) {
  if (measured_s == std::array<double, 2>{0.0, 0.0}) return std::nullopt;  // no method measured them
  const double off_s =
      std::max(std::abs(measured_s[0] - rig.left.row_time_s), std::abs(measured_s[1] - rig.right.row_time_s));
  return off_s * rig.height_px > kSameReadout_s ? std::optional(measured_s) : std::nullopt;
}

CamerasLearnt learntOf(const session::NavigationState& last, const cameras::StereoRig& rig) {
  CamerasLearnt learnt;
  if (!last.rig_fault.empty()) {
    if (haveMoved(last.rig_fault_detail)) learnt.moved = last.rig_fault;
    return learnt;
  }
  learnt.moved = last.rig_correction;
  if (learnt.moved.empty()) learnt.row_times_s = otherRowTimes(last.row_times_s, rig);
  return learnt;
}

void keepLearnt(const capture::RigStore& store, const std::string& name, const CamerasLearnt& learnt) {
  try {
    if (!learnt.moved.empty() && !isFaulty(store.read(name)))
      store.note(name,
                 capture::noteOfNow(toString(RigState::unclear), "in the last session: " + learnt.moved));
    if (const auto& times = learnt.row_times_s)
      store.noteRowTimes(name, {capture::noteOfNow({}, {}).utc, (*times)[0], (*times)[1]});
  } catch (const Error& error) {
    logWarning(error.what());
  }
}

}  // namespace facenav::workflow
