#include "patch_kernel.h"

#include "facenav/core/simd.h"

namespace facenav::head_tracking::patch {
namespace {

Sums sumPatch(const Image& image, const Samples& samples, const float m[12], const Placement& at) {
  Sums sums;
  const std::int64_t first = std::int64_t(at.patch) * kSamples;
  const float right = float(image.width - 2), bottom = float(image.height - 2);
  for (std::int64_t k = first; k < first + kSamples; ++k) {
    const float x = samples.x[k], y = samples.y[k], z = samples.z[k];
    const float w = 1.f / (m[6] * x + m[7] * y + m[8] * z + m[11]);
    const float nx = (m[0] * x + m[1] * y + m[2] * z + m[9]) * w;
    const float ny = (m[3] * x + m[4] * y + m[5] * z + m[10]) * w;
    const float u = at.d[0] * nx + at.d[1] * ny + at.offset[0] - float(image.left);
    const float v = at.d[2] * nx + at.d[3] * ny + at.offset[1] - float(image.top);
    if (!(u >= 0.f && v >= 0.f && u <= right && v <= bottom)) return Sums();
    const int iu = int(u), iv = int(v);
    const float fu = u - float(iu), fv = v - float(iv);
    const std::uint16_t* a = image.pixels + std::int64_t(iv) * image.stride + iu;
    const std::uint16_t* b = a + image.stride;
    const float top = float(a[0]) + fu * (float(a[1]) - float(a[0]));
    const float low = float(b[0]) + fu * (float(b[1]) - float(b[0]));
    const float grey = (top + fv * (low - top)) * (1.f / 256.f);
    sums.i += grey;
    sums.ii += grey * grey;
    sums.ti += samples.grey[k] * grey;
    sums.ui += samples.d_u[k] * grey;
    sums.vi += samples.d_v[k] * grey;
  }
  sums.is_inside = 1;
  return sums;
}

void sumPatches(const Image& image, const Samples& samples, const float camera_T_head[12],
                const Placement* placements, int count, Sums* sums) {
  for (int i = 0; i < count; ++i) sums[i] = sumPatch(image, samples, camera_T_head, placements[i]);
}

}  // namespace

Kernel baseKernel() { return sumPatches; }

Kernel kernel() {
  static const Kernel chosen = chooseKernel(baseKernel, avx2Kernel);
  return chosen;
}

}  // namespace facenav::head_tracking::patch
