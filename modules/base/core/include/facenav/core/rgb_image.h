#pragma once
// RgbImage: a picture made by the program (rendered scene, slice, camera view with overlays), as plain bytes.
// It lets scene (VTK), pictures (OpenCV, private) and the window (Qt) exchange pictures without sharing a
// library.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace facenav {
inline namespace core {

/// Row-major, top row first, 3 bytes (R, G, B) a pixel.
struct RgbImage {
  int width_px = 0, height_px = 0;
  std::vector<std::uint8_t> rgb;

  RgbImage() = default;
  RgbImage(int width, int height)
      : width_px(width), height_px(height), rgb(std::size_t(width) * height * 3) {}
  bool empty() const { return rgb.empty(); }
  std::uint8_t* pixel(int u, int v) { return rgb.data() + 3 * (std::size_t(v) * width_px + u); }
  const std::uint8_t* pixel(int u, int v) const { return rgb.data() + 3 * (std::size_t(v) * width_px + u); }
};

}  // namespace core
}  // namespace facenav
