#pragma once
// FrameBudget: the work that head and coil tracking may do together in one frame (frame_work.h), as settings.
// A larger budget finds a lost head or coil in fewer frames, and makes the slowest frame slower: a patch
// comparison takes 0.6 to 0.8 us, 7000 of them about 5 ms.

#include "facenav/core/setting.h"

namespace facenav {
inline namespace core {

struct FrameBudget {
  static constexpr const char* kModule = "core";
  static constexpr const char* kSubject = "work budget of a frame";

  int frame_comparisons = 7000;
  int coil_comparisons = 700;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kTimed("frame_comparisons", 4500, 100000, "1",
                   "patch comparisons, or other work of the same time, allowed in a frame"),
            self.frame_comparisons);
    visitor(kNotRecorded("coil_comparisons", 0, 2000, "1",
                         "share of them kept for a tracked coil while the head is searched"),
            self.coil_comparisons);
  }

 private:
  static constexpr Evidence kTimed{
      Origin::fitted,
      "by frame_benchmark on a slow host (60 frames a row): p99 of head and coil 7.1 ms without a common "
      "budget, "
      "4.2 ms with it, both lost 5.3 ms at most; not held out on another machine"};
  static constexpr Evidence kNotRecorded{Origin::chosen, "origin not recorded"};
};

}  // namespace core
}  // namespace facenav
