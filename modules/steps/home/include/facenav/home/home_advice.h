#pragma once
// The next step for a person at home, or a nurse: one sentence and one sign, from the newest state. The words
// are for people who never saw a navigator. If anything is unknown, the sign is none: no arrow is shown from
// an old or doubtful pose.

#include <future>
#include <string>

#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/core/error.h"
#include "facenav/session/navigation_state.h"

namespace facenav::steps {

/// Step: 1 sit and look, 2 hold the coil, 3 follow the arrow.
enum class HomeStep { sit, hold, follow };
/// Sign to show. raise_..: that side of the coil, for a person behind the handle who looks along the coil at
/// the head.
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
  /// Direction of the arrow, seen from behind the handle: 0 ahead (up on the screen), clockwise.
  double arrow_rad = 0;
  std::string words;        // one sentence
  bool is_refused = false;  // something is wrong or cannot be verified: stop
};

/// Chooses the advice. `sees_other_coil`: from OtherCoilWatch.
HomeAdvice homeAdvice(const session::NavigationState& state, bool sees_other_coil);

/// Reason why an alignment at home was refused, as one sentence to act on: another person, moved cameras, too
/// little of the face, dots that are off. Other faults: the error's own words.
std::string homeRefusal(const Error& error);

/// Searches the pictures now and then, on its own thread, for a print of the coil's dictionary that is not on
/// the coil, in both cameras, while the coil itself is not seen.
class OtherCoilWatch {
 public:
  explicit OtherCoilWatch(const coil_tracking::CoilModel& coil);
  /// Returns the last search's result at once. Call it once a frame or less often.
  bool sees(const session::NavigationState& state);

 private:
  coil_tracking::CoilModel coil_;
  std::future<bool> look_;
  Timestamp looked_{0};
  bool sees_ = false;
};

}  // namespace facenav::steps
