// Eight points at a time. The eight corners of a cell form four pairs along x. One 64-bit gather fetches the
// pairs of four points.

#include "point_kernel.h"

#if defined(__AVX2__) && defined(__FMA__)
#include <immintrin.h>

namespace facenav::registration::point {
namespace {

struct Vector {
  __m256 x, y, z;
};

inline __m256 splat(float value) { return _mm256_set1_ps(value); }
inline __m256i splat(int value) { return _mm256_set1_epi32(value); }

inline __m256 dot(const Vector& a, const Vector& b) {
  return _mm256_fmadd_ps(a.z, b.z, _mm256_fmadd_ps(a.y, b.y, _mm256_mul_ps(a.x, b.x)));
}

inline float sumOf(__m256 v) {
  __m128 s = _mm_add_ps(_mm256_castps256_ps128(v), _mm256_extractf128_ps(v, 1));
  s = _mm_add_ps(s, _mm_movehl_ps(s, s));
  return _mm_cvtss_f32(_mm_add_ss(s, _mm_shuffle_ps(s, s, 1)));
}

inline Vector turned(const View& view, const Vector& p) {
  const auto row = [&](int a) {
    return dot({splat(view.r[a][0]), splat(view.r[a][1]), splat(view.r[a][2])}, p);
  };
  return {row(0), row(1), row(2)};
}

/// True if 0 <= v < limit; false for NaN.
inline __m256 within(__m256 v, float limit) {
  return _mm256_and_ps(_mm256_cmp_ps(v, _mm256_setzero_ps(), _CMP_GE_OQ),
                       _mm256_cmp_ps(v, splat(limit), _CMP_LT_OQ));
}

inline __m256 within(const Vector& v, const int size[3]) {
  return _mm256_and_ps(_mm256_and_ps(within(v.x, float(size[0])), within(v.y, float(size[1]))),
                       within(v.z, float(size[2])));
}

struct Samples {
  __m256 distance_mm;
  Vector gradient;
};

/// Values at `index` and at its neighbour in +x.
struct Pairs {
  __m256 first, second;
};

inline Pairs pairsAt(const float* values, __m256i index) {
  const __m128i low = _mm256_castsi256_si128(index), high = _mm256_extracti128_si256(index, 1);
  // Gathers all lanes over zeros. The unmasked intrinsic would start from an uninitialised register.
  const __m256d zero = _mm256_setzero_pd(), all = _mm256_castsi256_pd(splat(-1));
  const auto gather = [&](__m128i some) {
    return _mm256_castpd_ps(
        _mm256_mask_i32gather_pd(zero, reinterpret_cast<const double*>(values), some, all, 4));
  };
  // Points 0 1 4 5 and 2 3 6 7: shuffling within halves then gives the right order.
  const __m256 a = gather(_mm_unpacklo_epi64(low, high)), b = gather(_mm_unpackhi_epi64(low, high));
  return {_mm256_shuffle_ps(a, b, 0x88), _mm256_shuffle_ps(a, b, 0xdd)};
}

/// Interpolates in the cells with lowest corner `index`. `f`: place within the cell, 0..1.
inline Samples interpolate(const float* values, __m256i index, int stride_y, int stride_z, const Vector& f,
                           float per_mm) {
  const Pairs c00 = pairsAt(values, index), c10 = pairsAt(values + stride_y, index),
              c01 = pairsAt(values + stride_z, index), c11 = pairsAt(values + stride_y + stride_z, index);
  const auto rise = [](const Pairs& c) { return _mm256_sub_ps(c.second, c.first); };
  const auto between = [](__m256 a, __m256 b, __m256 at) {
    return _mm256_fmadd_ps(at, _mm256_sub_ps(b, a), a);
  };
  const __m256 dx00 = rise(c00), dx10 = rise(c10), dx01 = rise(c01), dx11 = rise(c11);
  const __m256 a00 = _mm256_fmadd_ps(f.x, dx00, c00.first), a10 = _mm256_fmadd_ps(f.x, dx10, c10.first),
               a01 = _mm256_fmadd_ps(f.x, dx01, c01.first), a11 = _mm256_fmadd_ps(f.x, dx11, c11.first);
  const __m256 dy0 = _mm256_sub_ps(a10, a00), dy1 = _mm256_sub_ps(a11, a01);
  const __m256 b0 = _mm256_fmadd_ps(f.y, dy0, a00), b1 = _mm256_fmadd_ps(f.y, dy1, a01);
  const __m256 dz = _mm256_sub_ps(b1, b0), per = splat(per_mm);
  const __m256 dx = between(between(dx00, dx10, f.y), between(dx01, dx11, f.y), f.z);
  return {_mm256_fmadd_ps(f.z, dz, b0),
          {_mm256_mul_ps(dx, per), _mm256_mul_ps(between(dy0, dy1, f.z), per), _mm256_mul_ps(dz, per)}};
}

inline Vector inGrid(const FieldGrids& grids, const Vector& at_mm, float per_mm) {
  const __m256 per = splat(per_mm);
  return {_mm256_mul_ps(_mm256_sub_ps(at_mm.x, splat(grids.origin_mm[0])), per),
          _mm256_mul_ps(_mm256_sub_ps(at_mm.y, splat(grids.origin_mm[1])), per),
          _mm256_mul_ps(_mm256_sub_ps(at_mm.z, splat(grids.origin_mm[2])), per)};
}

/// Cells and the place within each, 0..1. Cell 0 where `is_inside` is false.
struct Cells {
  __m256i i, j, k;
  Vector f;

  Cells(const Vector& u, __m256 is_inside) {
    const auto cell = [&](__m256 v) {
      return _mm256_and_si256(_mm256_cvttps_epi32(v), _mm256_castps_si256(is_inside));
    };
    i = cell(u.x), j = cell(u.y), k = cell(u.z);
    f = {_mm256_sub_ps(u.x, _mm256_cvtepi32_ps(i)), _mm256_sub_ps(u.y, _mm256_cvtepi32_ps(j)),
         _mm256_sub_ps(u.z, _mm256_cvtepi32_ps(k))};
  }
};

/// i + stride_y (j + k stride)
inline __m256i indexOf(__m256i i, __m256i j, __m256i k, int size_x, int size_y) {
  const __m256i rows = _mm256_add_epi32(j, _mm256_mullo_epi32(k, splat(size_y)));
  return _mm256_add_epi32(i, _mm256_mullo_epi32(rows, splat(size_x)));
}

inline Samples coarse(const FieldGrids& grids, const Vector& at_mm) {
  constexpr float kPer_mm = 1.0f / FieldGrids::kCoarse_mm;
  const Vector u = inGrid(grids, at_mm, kPer_mm);
  const int* size = grids.coarse_size;
  const int cells[3] = {size[0] - 1, size[1] - 1, size[2] - 1};
  const __m256 is_inside = within(u, cells);
  const Cells at(u, is_inside);
  Samples out = interpolate(grids.coarse, indexOf(at.i, at.j, at.k, size[0], size[1]), size[0],
                            size[0] * size[1], at.f, kPer_mm);
  const __m256 zero = _mm256_setzero_ps();
  out.distance_mm = _mm256_blendv_ps(splat(FieldGrids::kFar_mm), out.distance_mm, is_inside);
  out.gradient.x = _mm256_blendv_ps(zero, out.gradient.x, is_inside);
  out.gradient.y = _mm256_blendv_ps(zero, out.gradient.y, is_inside);
  out.gradient.z = _mm256_blendv_ps(splat(1.0f), out.gradient.z, is_inside);
  return out;
}

inline Samples fine(const FieldGrids& grids, const Vector& at_mm) {
  static_assert(FieldGrids::kBrick == 4, "cells within a brick are the last two bits");
  constexpr float kPer_mm = 1.0f / FieldGrids::kFine_mm;
  const Vector u = inGrid(grids, at_mm, kPer_mm);
  const int* size = grids.brick_size;
  const int cells[3] = {FieldGrids::kBrick * size[0], FieldGrids::kBrick * size[1],
                        FieldGrids::kBrick * size[2]};
  const __m256 is_inside = within(u, cells);
  const Cells at(u, is_inside);
  const auto brickOf = [](__m256i cell) { return _mm256_srli_epi32(cell, 2); };
  const __m256i brick = _mm256_mask_i32gather_epi32(
      splat(-1), grids.brick_at, indexOf(brickOf(at.i), brickOf(at.j), brickOf(at.k), size[0], size[1]),
      _mm256_castps_si256(is_inside), 4);
  const __m256 has_brick = _mm256_castsi256_ps(_mm256_cmpgt_epi32(brick, splat(-1)));
  const int found = _mm256_movemask_ps(has_brick);
  if (found == 0) return coarse(grids, at_mm);
  const auto cellOf = [](__m256i cell) { return _mm256_and_si256(cell, splat(FieldGrids::kBrick - 1)); };
  const __m256i node = _mm256_add_epi32(
      indexOf(cellOf(at.i), cellOf(at.j), cellOf(at.k), FieldGrids::kSide, FieldGrids::kSide),
      _mm256_mullo_epi32(brick, splat(FieldGrids::kBrickNodes)));
  Samples out = interpolate(grids.bricks, _mm256_and_si256(node, _mm256_castps_si256(has_brick)),
                            FieldGrids::kSide, FieldGrids::kSide * FieldGrids::kSide, at.f, kPer_mm);
  if (found == 0xff) return out;
  const Samples beyond = coarse(grids, at_mm);
  out.distance_mm = _mm256_blendv_ps(beyond.distance_mm, out.distance_mm, has_brick);
  out.gradient.x = _mm256_blendv_ps(beyond.gradient.x, out.gradient.x, has_brick);
  out.gradient.y = _mm256_blendv_ps(beyond.gradient.y, out.gradient.y, has_brick);
  out.gradient.z = _mm256_blendv_ps(beyond.gradient.z, out.gradient.z, has_brick);
  return out;
}

/// All bits set where the skin at `at_mm` faces the camera.
inline __m256 hasCounterpart(const View& view, const Vector& at_mm, const Samples& skin) {
  const Vector to_camera{_mm256_sub_ps(splat(view.t[0]), at_mm.x), _mm256_sub_ps(splat(view.t[1]), at_mm.y),
                         _mm256_sub_ps(splat(view.t[2]), at_mm.z)};
  const __m256 facing = dot(skin.gradient, to_camera);
  const __m256 size = _mm256_andnot_ps(splat(-0.0f), facing);
  const __m256 least =
      _mm256_mul_ps(_mm256_mul_ps(splat(kGrazing_cos * kGrazing_cos), dot(to_camera, to_camera)),
                    dot(skin.gradient, skin.gradient));
  return _mm256_and_ps(_mm256_cmp_ps(_mm256_mul_ps(facing, size), least, _CMP_GT_OQ),
                       _mm256_cmp_ps(skin.distance_mm, splat(kNoSkin_mm), _CMP_LT_OQ));
}

void measure(const FieldGrids& grids, const Points& points, int first, int count, const View& view,
             bool is_fine, Block& block) {
  block.count = count;
  for (int i = 0; i < count; i += 8) {
    const auto load = [&](const float* const values[3]) {
      return Vector{_mm256_loadu_ps(values[0] + first + i), _mm256_loadu_ps(values[1] + first + i),
                    _mm256_loadu_ps(values[2] + first + i)};
    };
    Vector at_mm = turned(view, load(points.at_mm));
    at_mm = {_mm256_add_ps(at_mm.x, splat(view.t[0])), _mm256_add_ps(at_mm.y, splat(view.t[1])),
             _mm256_add_ps(at_mm.z, splat(view.t[2]))};
    const Samples skin = is_fine ? fine(grids, at_mm) : coarse(grids, at_mm);
    __m256 is_valid = hasCounterpart(view, at_mm, skin);
    if (points.normal[0])
      is_valid = _mm256_and_ps(is_valid, _mm256_cmp_ps(dot(skin.gradient, turned(view, load(points.normal))),
                                                       splat(kNormalsAgree_cos), _CMP_GT_OQ));
    _mm256_storeu_ps(block.at_mm[0] + i, at_mm.x);
    _mm256_storeu_ps(block.at_mm[1] + i, at_mm.y);
    _mm256_storeu_ps(block.at_mm[2] + i, at_mm.z);
    _mm256_storeu_ps(block.normal[0] + i, skin.gradient.x);
    _mm256_storeu_ps(block.normal[1] + i, skin.gradient.y);
    _mm256_storeu_ps(block.normal[2] + i, skin.gradient.z);
    _mm256_storeu_ps(block.residual_mm + i, skin.distance_mm);
    _mm256_storeu_ps(block.is_valid + i, _mm256_and_ps(is_valid, splat(1.0f)));
  }
}

constexpr int kWide = kBlock / 8;
struct Row {
  __m256 of[kWide];
};

Sums sum(const Block& block, const Points& points, int first, const Loss& loss) {
  const int wide = (block.count + 7) / 8;
  const __m256 outside = splat(1.0f / loss.outside_mm), inside = splat(1.0f / loss.inside_mm);
  Row row[7], weight;
  __m256 total = _mm256_setzero_ps();
  for (int w = 0; w < wide; ++w) {
    const int i = 8 * w;
    const __m256 is_valid =
        _mm256_cmp_ps(_mm256_loadu_ps(block.is_valid + i), _mm256_setzero_ps(), _CMP_GT_OQ);
    // Residual and normal are NaN if there is no counterpart. They are set to zero, since NaN times zero is
    // NaN.
    const auto valid = [&](const float* values) {
      return _mm256_and_ps(_mm256_loadu_ps(values + i), is_valid);
    };
    const auto from = [&](int a) { return _mm256_sub_ps(valid(block.at_mm[a]), splat(loss.pivot_mm[a])); };
    const __m256 residual = valid(block.residual_mm);
    const __m256 u = _mm256_mul_ps(residual, _mm256_blendv_ps(outside, inside, residual));
    const __m256 v = _mm256_max_ps(_mm256_setzero_ps(), _mm256_fnmadd_ps(u, u, splat(1.0f)));
    __m256 weigh = _mm256_and_ps(_mm256_mul_ps(v, v), is_valid);
    if (points.weight) weigh = _mm256_mul_ps(weigh, _mm256_loadu_ps(points.weight + first + i));
    const __m256 x = from(0), y = from(1), z = from(2);
    const __m256 nx = valid(block.normal[0]), ny = valid(block.normal[1]), nz = valid(block.normal[2]);
    row[0].of[w] = _mm256_fmsub_ps(y, nz, _mm256_mul_ps(z, ny));
    row[1].of[w] = _mm256_fmsub_ps(z, nx, _mm256_mul_ps(x, nz));
    row[2].of[w] = _mm256_fmsub_ps(x, ny, _mm256_mul_ps(y, nx));
    row[3].of[w] = nx, row[4].of[w] = ny, row[5].of[w] = nz, row[6].of[w] = residual;
    weight.of[w] = weigh;
    total = _mm256_add_ps(total, weigh);
  }
  Sums sums{};
  sums.weight = sumOf(total);
  float* product = sums.products;
  for (int r = 0; r < 7; ++r) {
    Row weighted;
    for (int w = 0; w < wide; ++w) weighted.of[w] = _mm256_mul_ps(row[r].of[w], weight.of[w]);
    for (int c = 0; c <= r; ++c) {
      __m256 s = _mm256_setzero_ps();
      for (int w = 0; w < wide; ++w) s = _mm256_fmadd_ps(weighted.of[w], row[c].of[w], s);
      *product++ = sumOf(s);
    }
  }
  return sums;
}

}  // namespace

const Kernel& avx2Kernel() {
  static const Kernel avx2{measure, sum};
  return avx2;
}

}  // namespace facenav::registration::point

#else

namespace facenav::registration::point {

const Kernel& avx2Kernel() { return baseKernel(); }

}  // namespace facenav::registration::point

#endif
