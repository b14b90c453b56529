#include "state_changes.h"

#include "facenav/core/number_text.h"
#include "facenav/core/without_folders.h"

namespace facenav::session {
namespace {

template <class Pose>
void noteFoundOrLost(bool& has, const Tracked<Pose>& pose, const char* what, casefile::SessionLog& log) {
  const bool has_now = bool(pose);
  if (has_now != has)
    log.addEvent(std::string(what) + (has_now ? " found" : " lost"), has_now ? "" : toString(pose.reason()));
  has = has_now;
}

}  // namespace

void StateChanges::note(const NavigationState& state, casefile::SessionLog& log) {
  if (state.frame >= 0 && state.coil_name != coil_) {
    log.addEvent("coil followed",
                 state.coil_name + formatted(", from frame %lld on", (long long)state.frame));
    coil_ = state.coil_name;
  }
  noteFoundOrLost(has_head_, state.camera_T_mri, "face", log);
  noteFoundOrLost(has_coil_, state.camera_T_coil, "coil", log);
  noteSecond(state, log);
  noteFault(state, log);
  if (state.rig_correction && !has_corrected_) log.addEvent("camera moved", inWords(*state.rig_correction));
  has_corrected_ = state.rig_correction.has_value();
  if (state.check && state.check->number != check_) {
    log.addEvent("registration check", inWords(*state.check));
    check_ = state.check->number;
  }
}

void StateChanges::noteSecond(const NavigationState& state, casefile::SessionLog& log) {
  if (!state.second || state.frame < 0) return;
  if (state.second->name != second_)
    log.addEvent("second coil followed",
                 state.second->name + formatted(", from frame %lld on", (long long)state.frame));
  second_ = state.second->name;
  noteFoundOrLost(has_second_, state.second->camera_T_coil, "second coil", log);
}

void StateChanges::noteFault(const NavigationState& state, casefile::SessionLog& log) {
  const auto of_cameras = rigFault(state);
  const std::string fault = !state.failure.empty() ? state.failure : of_cameras ? of_cameras->words() : "";
  if (!fault.empty() && !has_faulted_) log.addEvent("fault", withoutFolders(fault));
  has_faulted_ = !fault.empty();
  const bool is_away = isCameraAway(state);
  if (is_away && !away_) away_ = state.captured;
  if (is_away || !away_ || has_faulted_) return;
  log.addEvent("cameras back", formatted("after %.1f s", state.captured - *away_));
  away_.reset();
}

}  // namespace facenav::session
