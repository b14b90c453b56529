#pragma once
// FrameWork: what head and coil have cost together in one frame, and the most that a frame may cost. It is
// counted, not timed, so that the same frames give the same poses on any machine. The search for a lost head
// or coil ends at the frame's limit and goes on in the next frame, in its images. The head comes first.
// Search of the coil that was deferred has room reserved in the next frame.

namespace facenav {
inline namespace core {

struct FrameWork {
  static constexpr int kMost = 7000;  // looks that a frame may take
  int looks = 0;                      // at a skin patch, 0.6-0.8 us each; other work in the time of so many
  int left() const { return kMost - looks; }
};

}  // namespace core
}  // namespace facenav
