#pragma once
// FrameWork: the work that head and coil tracking have done together in one frame, and its limit
// (frame_budget.h). Work is
// counted, not timed, so that the same frames give the same poses on any machine. The search for a lost head
// or coil stops at the limit and continues in the next frame, with that frame's pictures. The head has
// priority. For search work that the coil had to defer, a part of the next frame's limit is reserved.

#include "facenav/core/frame_budget.h"
#include "facenav/core/settings_in_force.h"

namespace facenav {
inline namespace core {

struct FrameWork {
  int comparisons = 0;  // patch comparisons done, 0.6-0.8 us each; other work by its time
  /// Patch comparisons allowed in a frame.
  static int most() { return settingsOf<FrameBudget>().frame_comparisons; }
  int left() const { return most() - comparisons; }
};

}  // namespace core
}  // namespace facenav
