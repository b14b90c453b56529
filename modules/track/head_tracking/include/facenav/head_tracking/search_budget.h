#pragma once
// SearchBudget: work budget of a frame (core/frame_budget.h) beyond which the search for a lost head, or a
// fit from its result, is deferred to the next frame.

#include "facenav/core/setting.h"

namespace facenav::head_tracking {

struct SearchBudget {
  static constexpr const char* kModule = "head_tracking";
  static constexpr const char* kSubject = "work budget of the search for a lost head";

  int before_search = 2600;
  int before_fit = 3300;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kFilms("before_search", 0, 50000, "1",
                   "patch comparisons done in a frame above which the search waits for the next one"),
            self.before_search);
    visitor(kFilms("before_fit", 0, 50000, "1",
                   "patch comparisons done in a frame above which a fit waits for the next one"),
            self.before_fit);
  }

 private:
  static constexpr Evidence kFilms{
      Origin::fitted,
      "on nine recordings of the virtual room (296 frames, head alone, one slow core): p99 10.5 to 3.9 ms, "
      "longest frame 11.2 to 5.1 ms; 0 wrong poses, six more frames lost, each found in the next one; none "
      "held "
      "out"};
};

}  // namespace facenav::head_tracking
