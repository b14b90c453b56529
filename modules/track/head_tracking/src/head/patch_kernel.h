#pragma once
// The inner loop of the head track: patches of skin, placed in an image by pose and camera, and the sums over
// their samples from which gain, likeness and displacement follow. Compiled twice
// (facenav/core/simd.h).

#include <cstdint>

namespace facenav::head_tracking::patch {

constexpr int kSide = 8, kSamples = kSide * kSide;  // a multiple of 8: whole SIMD registers

struct Image {
  const std::uint16_t* pixels = nullptr;  // as in BlurredImage
  int stride = 0;                         // in pixels
  int left = 0, top = 0, width = 0, height = 0;
};

/// kSamples values per patch, one patch after the other.
struct Samples {
  const float *x = nullptr, *y = nullptr, *z = nullptr;         // Head, mm
  const float *grey = nullptr, *d_u = nullptr, *d_v = nullptr;  // factors of the image in the sums
};

/// Position of a patch in the image: pixel = d (x/z, y/z) + offset, the camera's model linearised there.
struct Placement {
  std::int32_t patch = 0;
  float d[4] = {0, 0, 0, 0}, offset[2] = {0, 0};
};

/// Sums over the samples, image values in grey levels. `is_inside` is 0 when a sample lies outside the image.
struct Sums {
  float i = 0, ii = 0, ti = 0, ui = 0, vi = 0;
  std::int32_t is_inside = 0;
};

/// `camera_T_head`: rotation, row by row, then translation (mm).
using Kernel = void (*)(const Image& image, const Samples& samples, const float camera_T_head[12],
                        const Placement* placements, int count, Sums* sums);

Kernel baseKernel();
Kernel avx2Kernel();
/// Returns the fastest version for this processor.
Kernel kernel();

}  // namespace facenav::head_tracking::patch
