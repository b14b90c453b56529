// Body of search..., included by block_kernel_base.cpp and block_kernel_avx2.cpp inside an anonymous
// namespace.

// 32 disparities of one 4 x 4 block.
inline void blockSums(const Images& im, const std::uint8_t* left, const std::uint8_t* right,
                      std::uint8_t* __restrict sums) {
  std::uint8_t total[kDisparityBlock] = {};
  for (int v = 0; v < kBlock; v += kRowStep)
    for (int u = 0; u < kBlock; ++u) {
      const std::uint8_t l = left[v * im.left_stride + u];
      const std::uint8_t* __restrict r = right + v * im.right_stride - u;
      for (int d = 0; d < kDisparityBlock; ++d) {
        const std::uint8_t high = l > r[d] ? l : r[d], low = l > r[d] ? r[d] : l;
        std::uint8_t difference = std::uint8_t(high - low);
        difference = difference < kLargestDifference ? difference : std::uint8_t(kLargestDifference);
        total[d] = std::uint8_t(total[d] + difference);
      }
    }
  for (int d = 0; d < kDisparityBlock; ++d) sums[d] = total[d];
}

inline void blockRow(const Images& im, int row, std::uint8_t* sums) {
  for (int column = 0; column < im.columns; ++column) {
    const std::uint8_t* left = im.left + row * kBlock * im.left_stride + column * kBlock;
    const std::uint8_t* right =
        im.right_mirrored + row * kBlock * im.right_stride + im.width - 1 - column * kBlock;
    for (int d = 0; d < im.disparities; d += kDisparityBlock)
      blockSums(im, left, right + d, sums + column * im.disparities + d);
  }
}

inline void addRows(const std::uint8_t* __restrict a, const std::uint8_t* __restrict b,
                    const std::uint8_t* __restrict c, int length, std::uint16_t* __restrict to) {
  for (int i = 0; i < length; ++i) to[i] = std::uint16_t(std::uint16_t(a[i]) + b[i] + c[i]);
}

struct Best {
  int disparity, cost;
};

// Sums of a window, the least of them and where it is; number[d] = d. Each loop is one reduction, which
// compilers turn into SIMD.
inline Best windowSums(const std::uint16_t* __restrict a, const std::uint16_t* __restrict b,
                       const std::uint16_t* __restrict c, const std::uint16_t* __restrict number,
                       int disparities, std::uint16_t* __restrict to) {
  std::uint16_t least = 65535, best = 65535;
  for (int d = 0; d < disparities; ++d) {
    const std::uint16_t sum = std::uint16_t(a[d] + b[d] + c[d]);
    to[d] = sum;
    least = sum < least ? sum : least;
  }
  for (int d = 0; d < disparities; ++d) {
    const std::uint16_t here = std::uint16_t(number[d] | std::uint16_t(-(to[d] != least)));
    best = here < best ? here : best;
  }
  return {best, least};
}

// Least cost of the disparities more than 2 away from `best`.
inline int secondBest(const std::uint16_t* __restrict costs, const std::uint16_t* __restrict number,
                      int disparities, int best) {
  const std::uint16_t first = std::uint16_t(best - 2);
  std::uint16_t second = 65535;
  for (int d = 0; d < disparities; ++d) {
    const std::uint16_t away = std::uint16_t(number[d] - first);  // 0 .. 4: too near
    const std::uint16_t cost = std::uint16_t(costs[d] | std::uint16_t(-(away <= 4)));
    second = cost < second ? cost : second;
  }
  return second;
}

// The best disparity to a fraction; -1 where another one (not next to it) is about as good.
inline float clearDisparity(const std::uint16_t* costs, const std::uint16_t* number, int count,
                               const Best& best, int uniqueness) {
  const int second = secondBest(costs, number, count, best.disparity);
  if ((second - best.cost) * 256 <= uniqueness * best.cost) return -1.0f;
  if (best.disparity == 0 || best.disparity + 1 >= count) return float(best.disparity);
  const int before = costs[best.disparity - 1], after = costs[best.disparity + 1];
  const int bend = before + after - 2 * best.cost;
  return float(best.disparity) + (bend > 0 ? 0.5f * float(before - after) / float(bend) : 0.0f);
}

inline void search(const Images& im, int first, int last, int uniqueness, std::uint8_t* scratch,
                   float* disparity, int stride) {
  const int n = im.disparities, length = im.columns * n;
  // 16-bit arrays first, for their alignment.
  std::uint16_t* column = reinterpret_cast<std::uint16_t*>(scratch);
  std::uint16_t* costs = column + length;
  std::uint16_t* number = costs + n;  // 0, 1, 2 ..: what SIMD compares with
  for (int d = 0; d < n; ++d) number[d] = std::uint16_t(d);
  std::uint8_t* ring = reinterpret_cast<std::uint8_t*>(number + n);
  const auto inside = [&](int row) { return row < 0 ? 0 : (row >= im.rows ? im.rows - 1 : row); };
  const auto slot = [&](int row) { return ring + std::int64_t(inside(row) % 3) * length; };
  blockRow(im, inside(first - 1), slot(first - 1));
  if (first > 0) blockRow(im, first, slot(first));
  for (int row = first; row < last; ++row) {
    if (row + 1 < im.rows) blockRow(im, row + 1, slot(row + 1));
    addRows(slot(row - 1), slot(row), slot(row + 1), length, column);
    for (int i = 0; i < im.columns; ++i) {
      const int before = i > 0 ? i - 1 : 0, after = i + 1 < im.columns ? i + 1 : i;
      const Best best = windowSums(column + before * n, column + i * n, column + after * n, number, n, costs);
      disparity[std::int64_t(row) * stride + i] = clearDisparity(costs, number, n, best, uniqueness);
    }
  }
}

// One row of levels: (grey * scale + offset) limited to 0 .. highest; `invalid` where the mask is 0.
inline void levels(const float* __restrict grey, const std::uint8_t* __restrict mask,
                   const float* __restrict scale, const float* __restrict offset, int width, int highest,
                   int invalid, std::uint8_t* __restrict out) {
  for (int x = 0; x < width; ++x) {
    float level = grey[x] * scale[x] + offset[x];
    level = level > 0.0f ? level : 0.0f;  // no number: 0
    level = level < float(highest) ? level : float(highest);
    const int value = mask[x] ? int(level) : invalid;
    out[x] = std::uint8_t(value);
  }
}

// Adds up cells of 4 x 4 pixels: grey levels and their squares. `columns`: 2 * width floats of scratch
// memory.
inline void cellSums(const float* image, int stride, int width, float* __restrict columns,
                     float* __restrict sums, float* __restrict squares) {
  float* __restrict s = columns;
  float* __restrict q = columns + width;
  for (int x = 0; x < width; ++x) {
    const float a = image[x], b = image[stride + x], c = image[2 * stride + x], d = image[3 * stride + x];
    s[x] = (a + b) + (c + d);
    q[x] = (a * a + b * b) + (c * c + d * d);
  }
  for (int i = 0; i < width / kBlock; ++i) {
    sums[i] = (s[4 * i] + s[4 * i + 1]) + (s[4 * i + 2] + s[4 * i + 3]);
    squares[i] = (q[4 * i] + q[4 * i + 1]) + (q[4 * i + 2] + q[4 * i + 3]);
  }
}
