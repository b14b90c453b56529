#pragma once
// SkinPaint: something that covers the skin's picture at a point: its opacity (0..1) and its albedo.

namespace facenav::room {

struct SkinPaint {
  float share = 0.f, albedo = 0.f;
};

}  // namespace facenav::room
