#pragma once
// FrameWork: the work that head and coil tracking have done together in one frame, and its limit. Work is
// counted, not timed, so that the same frames give the same poses on any machine. The search for a lost head
// or coil stops at the limit and continues in the next frame, with that frame's pictures. The head has
// priority. For search work that the coil had to defer, a part of the next frame's limit is reserved.

namespace facenav {
inline namespace core {

struct FrameWork {
  static constexpr int kMost = 7000;  // patch comparisons allowed in a frame
  int comparisons = 0;                // patch comparisons done, 0.6-0.8 us each; other work by its time
  int left() const { return kMost - comparisons; }
};

}  // namespace core
}  // namespace facenav
