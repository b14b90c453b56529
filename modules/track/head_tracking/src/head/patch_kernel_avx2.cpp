// Eight samples at a time. One 32-bit gather fetches two neighbouring pixels; the last pixel of the image is
// never the first of a pair, so nothing beyond it is read.

#include "patch_kernel.h"

#if defined(__AVX2__) && defined(__FMA__)
#include <immintrin.h>

namespace facenav::head_tracking::patch {
namespace {

inline float sumOf(__m256 v) {
  __m128 s = _mm_add_ps(_mm256_castps256_ps128(v), _mm256_extractf128_ps(v, 1));
  s = _mm_add_ps(s, _mm_movehl_ps(s, s));
  return _mm_cvtss_f32(_mm_add_ss(s, _mm_shuffle_ps(s, s, 1)));
}

inline __m256 row(const float m[12], int r, __m256 x, __m256 y, __m256 z) {
  __m256 s = _mm256_fmadd_ps(_mm256_set1_ps(m[3 * r]), x, _mm256_set1_ps(m[9 + r]));
  s = _mm256_fmadd_ps(_mm256_set1_ps(m[3 * r + 1]), y, s);
  return _mm256_fmadd_ps(_mm256_set1_ps(m[3 * r + 2]), z, s);
}

// Interpolates pairs of pixels: the first plus `f` times the difference.
inline __m256 between(__m256i pairs, __m256 f) {
  const __m256 first = _mm256_cvtepi32_ps(_mm256_and_si256(pairs, _mm256_set1_epi32(0xffff)));
  const __m256 second = _mm256_cvtepi32_ps(_mm256_srli_epi32(pairs, 16));
  return _mm256_fmadd_ps(f, _mm256_sub_ps(second, first), first);
}

inline Sums sumPatch(const Image& image, const Samples& samples, const float m[12], const Placement& at) {
  const std::int64_t first = std::int64_t(at.patch) * kSamples;
  const __m256 zero = _mm256_setzero_ps(), right = _mm256_set1_ps(float(image.width - 2)),
               bottom = _mm256_set1_ps(float(image.height - 2));
  const __m256 offset_u = _mm256_set1_ps(at.offset[0] - float(image.left)),
               offset_v = _mm256_set1_ps(at.offset[1] - float(image.top));
  __m256 i = zero, ii = zero, ti = zero, ui = zero, vi = zero;
  for (int k = 0; k < kSamples; k += 8) {
    const __m256 x = _mm256_loadu_ps(samples.x + first + k), y = _mm256_loadu_ps(samples.y + first + k),
                 z = _mm256_loadu_ps(samples.z + first + k);
    const __m256 w = _mm256_div_ps(_mm256_set1_ps(1.f), row(m, 2, x, y, z));
    const __m256 nx = _mm256_mul_ps(row(m, 0, x, y, z), w), ny = _mm256_mul_ps(row(m, 1, x, y, z), w);
    const __m256 u =
        _mm256_fmadd_ps(_mm256_set1_ps(at.d[0]), nx, _mm256_fmadd_ps(_mm256_set1_ps(at.d[1]), ny, offset_u));
    const __m256 v =
        _mm256_fmadd_ps(_mm256_set1_ps(at.d[2]), nx, _mm256_fmadd_ps(_mm256_set1_ps(at.d[3]), ny, offset_v));
    const __m256 inside = _mm256_and_ps(
        _mm256_and_ps(_mm256_cmp_ps(u, zero, _CMP_GE_OQ), _mm256_cmp_ps(v, zero, _CMP_GE_OQ)),
        _mm256_and_ps(_mm256_cmp_ps(u, right, _CMP_LE_OQ), _mm256_cmp_ps(v, bottom, _CMP_LE_OQ)));
    if (_mm256_movemask_ps(inside) != 0xff) return Sums();
    const __m256i iu = _mm256_cvttps_epi32(u), iv = _mm256_cvttps_epi32(v);
    const __m256 fu = _mm256_sub_ps(u, _mm256_cvtepi32_ps(iu)), fv = _mm256_sub_ps(v, _mm256_cvtepi32_ps(iv));
    const __m256i index = _mm256_add_epi32(_mm256_mullo_epi32(iv, _mm256_set1_epi32(image.stride)), iu);
    const __m256i upper = _mm256_i32gather_epi32(reinterpret_cast<const int*>(image.pixels), index, 2);
    const __m256i lower =
        _mm256_i32gather_epi32(reinterpret_cast<const int*>(image.pixels + image.stride), index, 2);
    const __m256 top = between(upper, fu), low = between(lower, fu);
    const __m256 grey =
        _mm256_mul_ps(_mm256_fmadd_ps(fv, _mm256_sub_ps(low, top), top), _mm256_set1_ps(1.f / 256.f));
    i = _mm256_add_ps(i, grey);
    ii = _mm256_fmadd_ps(grey, grey, ii);
    ti = _mm256_fmadd_ps(_mm256_loadu_ps(samples.grey + first + k), grey, ti);
    ui = _mm256_fmadd_ps(_mm256_loadu_ps(samples.d_u + first + k), grey, ui);
    vi = _mm256_fmadd_ps(_mm256_loadu_ps(samples.d_v + first + k), grey, vi);
  }
  Sums sums;
  sums.i = sumOf(i), sums.ii = sumOf(ii), sums.ti = sumOf(ti), sums.ui = sumOf(ui), sums.vi = sumOf(vi);
  sums.is_inside = 1;
  return sums;
}

void sumPatches(const Image& image, const Samples& samples, const float camera_T_head[12],
                const Placement* placements, int count, Sums* sums) {
  for (int i = 0; i < count; ++i) sums[i] = sumPatch(image, samples, camera_T_head, placements[i]);
}

}  // namespace

Kernel avx2Kernel() { return sumPatches; }

}  // namespace facenav::head_tracking::patch

#else

namespace facenav::head_tracking::patch {

Kernel avx2Kernel() { return baseKernel(); }

}  // namespace facenav::head_tracking::patch

#endif
