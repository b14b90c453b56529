#pragma once
// What a person at home, or a nurse, does next: one step, one sentence, one sign, from the newest state. The
// words are for people who never saw a navigator. When anything is not known, the sign is none: no arrow is
// ever shown from an old or doubtful pose.

#include <future>
#include <string>

#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/core/error.h"
#include "facenav/session/navigation_state.h"

namespace facenav::steps {

/// 1 sit and look, 2 hold the coil, 3 follow the arrow.
enum class HomeStep { sit, hold, follow };
/// raise_..: that side of the coil, for a person behind the handle who looks along the coil at the head.
enum class HomeSign {
  none,
  arrow,
  lift,
  press,
  turn_clockwise,
  turn_counterclockwise,
  raise_left,
  raise_right,
  raise_handle,
  raise_front,
  hold
};

struct HomeAdvice {
  HomeStep step = HomeStep::sit;
  HomeSign sign = HomeSign::none;
  /// Of the arrow, seen from behind the handle: 0 ahead (up on the screen), clockwise.
  double arrow_rad = 0;
  std::string words;        // one sentence
  bool is_refused = false;  // something that cannot be verified, or is wrong: nothing may be done
};

/// `sees_other_coil`: as OtherCoilWatch says.
HomeAdvice homeAdvice(const session::NavigationState& state, bool sees_other_coil);

/// Why an alignment at home was refused, as one sentence to act on: another person, moved cameras, too little
/// of the face, dots that are off. Other faults: the error's own words.
std::string homeRefusal(const Error& error);

/// Looks now and then, on a thread of its own, whether the pictures show a print of the coil's dictionary
/// that is not on the coil, in both cameras, while the coil itself is not seen.
class OtherCoilWatch {
 public:
  explicit OtherCoilWatch(const coil_tracking::CoilModel& coil);
  /// Once a frame or less often; returns at once with what the last look said.
  bool sees(const session::NavigationState& state);

 private:
  coil_tracking::CoilModel coil_;
  std::future<bool> look_;
  Timestamp looked_{0};
  bool sees_ = false;
};

}  // namespace facenav::steps
