#pragma once
// FrameWork: what head and coil have cost together in one frame. Counted, not timed, so that the same frames
// give the same poses on any machine. A lost head or coil is looked for as far as the frame's limit allows
// and further in the next frame, in its pictures; the head comes first, and what the coil had to put off is
// left room for in the next frame.

namespace facenav {

struct FrameWork {
  static constexpr int kMost = 7000;  // looks that a frame may take
  int looks = 0;                      // at a skin patch, 0.6-0.8 us each; other work in the time of so many
  int left() const { return kMost - looks; }
};

}  // namespace facenav
