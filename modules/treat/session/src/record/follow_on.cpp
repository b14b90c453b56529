#include "follow_on.h"

#include <algorithm>

namespace facenav::session {
namespace {

constexpr double kLeastBreak_s = 1.0;  // between the frames of two runs, if no clock is shared

}  // namespace

FollowOn followOn(const casefile::SessionSoFar& so_far, const NavigationState& first) {
  FollowOn on;
  if (!so_far.last_frame) return on;
  if (first.frame <= *so_far.last_frame) on.frames = *so_far.last_frame + 1;
  if (first.captured.s <= so_far.last_t_s)
    on.seconds = so_far.last_t_s + std::max(kLeastBreak_s, so_far.idle_s) - first.captured.s;
  return on;
}

}  // namespace facenav::session
