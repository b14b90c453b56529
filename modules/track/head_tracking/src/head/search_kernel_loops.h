// The loops of search_kernel.h, included by one translation unit per instruction set. They are simple, so
// that the compiler vectorises them over kLanes results.

#include "search_kernel.h"

namespace facenav::head_tracking::search {
namespace {

using Lanes = float __attribute__((vector_size(kLanes * sizeof(float))));
using Places = std::int32_t __attribute__((vector_size(kLanes * sizeof(float))));

inline Lanes eightOf(const float* values) {
  Lanes lanes;
  __builtin_memcpy(&lanes, values, sizeof lanes);
  return lanes;
}

// Window sums of one row from the column sums: 2, 4, 8, then 8 + 2 + 1 values together.
void sumAlong(const std::int32_t* __restrict columns, std::int32_t* __restrict two,
              std::int32_t* __restrict four, std::int32_t* __restrict sums, int count) {
  for (int x = 0; x < count + 9; ++x) two[x] = columns[x] + columns[x + 1];
  for (int x = 0; x < count + 4; ++x) four[x] = two[x] + two[x + 2];
  for (int x = 0; x < count; ++x) sums[x] = four[x] + four[x + 4] + two[x + 8] + columns[x + 10];
}

void evenRow(const std::uint16_t* __restrict grey, const std::int32_t* __restrict sums,
             const std::int32_t* __restrict squares, const Evening& task, float* __restrict to) {
  constexpr float kArea = kWindow * kWindow;
  for (int x = 0; x < task.columns; ++x) {
    const float mean = float(sums[x]) * (1.f / (256.f * kArea));
    const float variance = float(squares[x]) * (1.f / (256.f * kArea)) - mean * mean;
    const float least = task.least_contrast + task.per_mean * mean;
    const float spread = (variance > 0.f ? variance : 0.f) + least * least;
    to[x] = (float(grey[x]) * (1.f / 256.f) - mean) / __builtin_sqrtf(spread);
  }
}

// Squares in sixteenths of a grey level: 121 of them fit into 31 bits.
inline std::int32_t square(std::uint16_t grey) {
  const std::int32_t sixteenth = grey >> 4;
  return sixteenth * sixteenth;
}

void evenLoop(const Evening& task) {
  const int wide = task.columns + kWindow - 1, space = task.columns + kWindow + kLanes;
  std::int32_t *sums = task.scratch, *squares = sums + space, *two = squares + space, *four = two + space,
               *sum = four + space, *square_sum = sum + space;
  for (int x = 0; x < wide; ++x) sums[x] = squares[x] = 0;
  for (int y = 0; y < task.rows + kWindow - 1; ++y) {
    const std::uint16_t* __restrict in = task.from + std::int64_t(y) * task.from_stride;
    for (int x = 0; x < wide; ++x) sums[x] += in[x], squares[x] += square(in[x]);
    const int row = y - kWindow + 1;
    if (row < 0) continue;
    sumAlong(sums, two, four, sum, task.columns);
    sumAlong(squares, two, four, square_sum, task.columns);
    evenRow(task.from + std::int64_t(row + kRim) * task.from_stride + kRim, sum, square_sum, task,
            task.to + std::int64_t(row) * task.to_stride);
    const std::uint16_t* __restrict out = task.from + std::int64_t(row) * task.from_stride;
    for (int x = 0; x < wide; ++x) sums[x] -= out[x], squares[x] -= square(out[x]);
  }
}

template <int kBlocks>
inline void correlateBlocks(const Correlation& task, int y, int x) {
  Lanes sums[kBlocks] = {};
  const std::int64_t at = std::int64_t(y) * task.stride + x;
  for (int i = 0; i < task.count; ++i) {
    const float* in = task.from[i] + at;
    const float value = task.value[i];
    for (int b = 0; b < kBlocks; ++b) {
      sums[b] += value * eightOf(in + b * kLanes);
    }
  }
  __builtin_memcpy(task.sums + std::int64_t(y) * task.columns + x, sums, sizeof sums);
}

void correlateLoop(const Correlation& task) {
  for (int y = 0; y < task.rows; ++y) {
    int x = 0;
    for (; x + 5 * kLanes <= task.columns; x += 5 * kLanes) correlateBlocks<5>(task, y, x);
    for (; x < task.columns; x += kLanes) correlateBlocks<1>(task, y, x);
  }
}

inline bool areAll(const Places& condition) {
  std::int32_t all = -1;
  for (int k = 0; k < kLanes; ++k) all &= condition[k];
  return all != 0;
}

bool sampleLoop(const Sampling& task) {
  const float* m = task.camera_T_head;
  for (int i = 0; i < task.count; i += kLanes) {
    const Lanes x = eightOf(task.x + i), y = eightOf(task.y + i), z = eightOf(task.z + i);
    const Lanes w = 1.f / (m[6] * x + m[7] * y + m[8] * z + m[11]),
                flat_x = w * (m[0] * x + m[1] * y + m[2] * z + m[9]),
                flat_y = w * (m[3] * x + m[4] * y + m[5] * z + m[10]);
    Lanes u = task.d[0] * flat_x + task.d[1] * flat_y + (task.offset[0] - float(task.left)),
          v = task.d[2] * flat_x + task.d[3] * flat_y + (task.offset[1] - float(task.top));
    if (!areAll((u >= 0.f) & (v >= 0.f) & (u < float(task.width - 1)) & (v < float(task.height - 1))))
      return false;
    const Places iu = __builtin_convertvector(u, Places), iv = __builtin_convertvector(v, Places);
    u -= __builtin_convertvector(iu, Lanes), v -= __builtin_convertvector(iv, Lanes);
    std::int32_t fetched[4][kLanes];
    for (int k = 0; k < kLanes; ++k) {
      const std::uint16_t* at = task.pixels + std::int64_t(iv[k]) * task.stride + iu[k];
      fetched[0][k] = at[0], fetched[1][k] = at[1];
      fetched[2][k] = at[task.stride], fetched[3][k] = at[task.stride + 1];
    }
    Places p[4];
    __builtin_memcpy(p, fetched, sizeof fetched);
    const Lanes a = __builtin_convertvector(p[0], Lanes), b = __builtin_convertvector(p[1], Lanes),
                c = __builtin_convertvector(p[2], Lanes), d = __builtin_convertvector(p[3], Lanes);
    const Lanes upper = a + u * (b - a), lower = c + u * (d - c);
    const Lanes grey = (upper + v * (lower - upper)) * (1.f / 256.f);
    __builtin_memcpy(task.to + i, &grey, sizeof grey);
  }
  return true;
}

template <int kRows>
inline void expandRows(const Expansion& task, int i) {
  constexpr int kBlocks = Expansion::kPatterns / kLanes;
  Lanes sums[kRows][kBlocks] = {};
  const float* values = task.values + std::int64_t(i) * task.length;
  for (int k = 0; k < task.length; ++k)
    for (int b = 0; b < kBlocks; ++b) {
      const Lanes pattern = eightOf(task.patterns + k * Expansion::kPatterns + b * kLanes);
      for (int r = 0; r < kRows; ++r) sums[r][b] += values[r * task.length + k] * pattern;
    }
  __builtin_memcpy(task.to + std::int64_t(i) * Expansion::kPatterns, sums, sizeof sums);
}

void expandLoop(const Expansion& task) {
  int i = 0;
  for (; i + 2 <= task.count; i += 2) expandRows<2>(task, i);
  if (i < task.count) expandRows<1>(task, i);
}

inline float sumOf(const Lanes& lanes) {
  float all = 0;
  for (int k = 0; k < kLanes; ++k) all += lanes[k];
  return all;
}

inline void invertRoot(Lanes& lanes) {
  for (int k = 0; k < kLanes; ++k) lanes[k] = 1.f / __builtin_sqrtf(lanes[k]);
}

/// One block of points in the image.
struct Block {
  Lanes j[6], e, weight, now;  // weight 0: outside the image
};

// The four pixels round each place.
inline void fetch(const TemplateView& view, const Places& iu, const Places& iv, Lanes pixels[4]) {
  float fetched[4][kLanes];
  for (int k = 0; k < kLanes; ++k) {
    const float* at = view.image + std::int64_t(iv[k]) * view.stride + iu[k];
    fetched[0][k] = at[0], fetched[1][k] = at[1];
    fetched[2][k] = at[view.stride], fetched[3][k] = at[view.stride + 1];
  }
  __builtin_memcpy(pixels, fetched, sizeof fetched);
}

inline void compareAt(const TemplateView& view, const Lanes* f, Block& block) {
  using F = TemplateField;
  const float* m = view.camera_T_head;
  const Lanes x = f[F::x], y = f[F::y], z = f[F::z], zero = {};
  const Lanes cx = m[0] * x + m[1] * y + m[2] * z + m[9], cy = m[3] * x + m[4] * y + m[5] * z + m[10],
              cz = m[6] * x + m[7] * y + m[8] * z + m[11];
  const Lanes nx = f[F::normal_x], ny = f[F::normal_y], nz = f[F::normal_z];
  Lanes per_distance = cx * cx + cy * cy + cz * cz + 1e-6f;
  invertRoot(per_distance);
  const Lanes towards =
      -((m[0] * nx + m[1] * ny + m[2] * nz) * cx + (m[3] * nx + m[4] * ny + m[5] * nz) * cy +
        (m[6] * nx + m[7] * ny + m[8] * nz) * cz) *
      per_distance;
  const Places is_before = cz > 1.f;
  const Lanes w = 1.f / (is_before ? cz : zero + 1.f), flat_x = cx * w, flat_y = cy * w;
  Lanes u = f[F::d00] * flat_x + f[F::d01] * flat_y + f[F::u0],
        v = f[F::d10] * flat_x + f[F::d11] * flat_y + f[F::v0];
  const Places is_seen = is_before & (u >= 0.f) & (v >= 0.f) & (u < float(view.width - 1)) &
                         (v < float(view.height - 1)) & (f[F::weight] > 0.f) & (towards >= view.least_facing);
  u = is_seen ? u : zero, v = is_seen ? v : zero;
  const Places iu = __builtin_convertvector(u, Places), iv = __builtin_convertvector(v, Places);
  u -= __builtin_convertvector(iu, Lanes), v -= __builtin_convertvector(iv, Lanes);
  Lanes p[4];
  fetch(view, iu, iv, p);
  const Lanes top = p[0] + u * (p[1] - p[0]), slope_v = p[2] + u * (p[3] - p[2]) - top,
              slope_u = p[1] - p[0] + v * (p[3] - p[2] - p[1] + p[0]);
  block.now = top + v * slope_v;
  block.e = f[F::value] - block.now;
  const Lanes q = block.e * (1.f / view.reach), influence = f[F::weight] < towards ? f[F::weight] : towards;
  block.weight = is_seen ? influence / (1.f + q * q) : zero;
  const Lanes by_x = (slope_u * f[F::d00] + slope_v * f[F::d10]) * w,
              by_y = (slope_u * f[F::d01] + slope_v * f[F::d11]) * w, by_z = -(by_x * flat_x + by_y * flat_y);
  const Lanes hx = by_x * m[0] + by_y * m[3] + by_z * m[6], hy = by_x * m[1] + by_y * m[4] + by_z * m[7],
              hz = by_x * m[2] + by_y * m[5] + by_z * m[8];
  const Lanes rx = x - view.centre[0], ry = y - view.centre[1], rz = z - view.centre[2];
  block.j[0] = ry * hz - rz * hy, block.j[1] = rz * hx - rx * hz, block.j[2] = rx * hy - ry * hx;
  block.j[3] = hx, block.j[4] = hy, block.j[5] = hz;
}

TemplateSums sumLoop(const TemplateView& view) {
  Lanes normal[21] = {}, pull[6] = {}, product = {}, now_squares = {}, then_squares = {}, seen = {};
  Block block;
  for (int b = 0; b < view.block_count; ++b) {
    Lanes f[TemplateField::count];
    __builtin_memcpy(f, view.blocks + std::int64_t(b) * TemplateField::count * kLanes, sizeof f);
    compareAt(view, f, block);
    for (int i = 0, n = 0; i < 6; ++i) {
      const Lanes weighted = block.weight * block.j[i];
      pull[i] += weighted * block.e;
      for (int j = i; j < 6; ++j, ++n) normal[n] += weighted * block.j[j];
    }
    const Lanes then = f[TemplateField::value], weighted_now = block.weight * block.now;
    product += weighted_now * then, now_squares += weighted_now * block.now;
    then_squares += block.weight * then * then;
    seen += block.weight > 0.f ? Lanes{} + 1.f : Lanes{};
  }
  TemplateSums sums;
  for (int n = 0; n < 21; ++n) sums.normal[n] = sumOf(normal[n]);
  for (int i = 0; i < 6; ++i) sums.pull[i] = sumOf(pull[i]);
  sums.product = sumOf(product), sums.now_squares = sumOf(now_squares);
  sums.then_squares = sumOf(then_squares), sums.seen = sumOf(seen);
  return sums;
}

constexpr Kernel kLoops = {evenLoop, correlateLoop, sampleLoop, expandLoop, sumLoop};

}  // namespace
}  // namespace facenav::head_tracking::search
