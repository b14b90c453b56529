#pragma once
// SkinPaint: something that covers the skin's own picture at a point: the share (0..1) that it covers, and
// its albedo.

namespace facenav::room {

struct SkinPaint {
  float share = 0.f, albedo = 0.f;
};

}  // namespace facenav::room
