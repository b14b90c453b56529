#include "facenav/monitoring/withheld.h"

#include "facenav/core/number_text.h"

namespace facenav::monitoring {

std::string bannerOf(health::RigState state) {
  switch (state) {
    case health::RigState::swapped:
      return "CAMERAS SWAPPED: exchange left and right";
    case health::RigState::out_of_step:
      return "CAMERAS OUT OF STEP: trigger both together, or check cables and driver";
    case health::RigState::other_cameras:
      return "OTHER CAMERAS' CALIBRATION: give the right stereo.yml, or calibrate";
    case health::RigState::moved:
      return "CAMERAS MOVED: calibrate them again";
    case health::RigState::disagree:
      return "CAMERAS DISAGREE: one has moved, or they expose at different moments";
    case health::RigState::away:
      return "CAMERA AWAY: plug it in again, the session goes on by itself";
    case health::RigState::unclear:
    case health::RigState::holds:
      break;
  }
  return {};
}

std::string bannerOf(const Withheld& withheld) {
  switch (withheld.reason) {
    case Withheld::Reason::camera_fault:
      return bannerOf(withheld.rig.state);
    case Withheld::Reason::drifted:
      return "DRIFT: the face no longer matches the MRI, align again";
    case Withheld::Reason::not_checked:
      return "REGISTRATION NOT CHECKED: show the whole face to both cameras";
    case Withheld::Reason::registration_failed:
      return formatted("REGISTRATION FAILED: the face is %.1f mm and %.1f deg off, align again",
                       withheld.shift_mm, withheld.turn_deg);
    case Withheld::Reason::judged_wrong:
      return "ALIGNMENT JUDGED WRONG: align again";
  }
  return {};
}

std::string wordOf(const Withheld& withheld) {
  if (withheld.reason == Withheld::Reason::drifted) return "drift";
  if (withheld.reason != Withheld::Reason::camera_fault) return "not_checked";
  switch (withheld.rig.state) {
    case health::RigState::moved:
      return "cameras_moved";
    case health::RigState::other_cameras:
      return "other_rig";
    case health::RigState::away:
      return "camera_away";
    default:
      return health::toString(withheld.rig.state);
  }
}

}  // namespace facenav::monitoring
