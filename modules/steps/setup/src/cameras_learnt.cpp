#include "facenav/setup/cameras_learnt.h"

#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/health/rig_state.h"

namespace facenav::steps {
namespace {

constexpr double kSameReadout_s =
    0.5e-3;  // of a whole picture: less moves a coil of 1 m/s by 0.25 mm at most

bool isFaulty(const capture::NamedRig& rig) {
  return rig.last_check && health::isWrongGeometry(health::rigStateNamed(rig.last_check->state));
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
  if (const auto fault = session::rigFault(last)) {
    if (health::isWrongGeometry(fault->state)) learnt.moved = fault->words();
    return learnt;
  }
  if (last.rig_correction) learnt.moved = inWords(*last.rig_correction);
  if (learnt.moved.empty()) learnt.row_times_s = otherRowTimes(last.row_times_s, rig);
  return learnt;
}

void keepLearnt(const capture::RigStore& store, const std::string& name, const CamerasLearnt& learnt) {
  try {
    if (!learnt.moved.empty() && !isFaulty(store.read(name)))
      store.note(name, capture::noteOfNow(health::toString(health::RigState::unclear),
                                          "in the last session: " + learnt.moved));
    if (const auto& times = learnt.row_times_s)
      store.noteRowTimes(name, {capture::noteOfNow({}, {}).utc, (*times)[0], (*times)[1]});
  } catch (const Error& error) {
    logWarning(error.what());
  }
}

}  // namespace facenav::steps
