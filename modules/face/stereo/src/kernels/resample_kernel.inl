// Body of the resampling kernels, included by resample_kernel_base.cpp and resample_kernel_avx2.cpp inside an
// anonymous namespace.

inline void filterColumns(float* image, int stride, int width, int height, float pole) {
  const auto row = [&](int y) { return image + std::int64_t(y) * stride; };
  constexpr int kStart = 16;  // 0.43^16: nothing is left
  float power = 1;
  for (int y = 1; y < height && y < kStart; ++y) {
    power *= pole;
    float* __restrict first = row(0);
    const float* __restrict other = row(y);
    for (int x = 0; x < width; ++x) first[x] += power * other[x];
  }
  for (int y = 1; y < height; ++y) {
    float* __restrict here = row(y);
    const float* __restrict before = row(y - 1);
    for (int x = 0; x < width; ++x) here[x] += pole * before[x];
  }
  if (height < 2) return;
  {
    float* __restrict last = row(height - 1);
    const float* __restrict before = row(height - 2);
    const float factor = pole / (pole * pole - 1);
    for (int x = 0; x < width; ++x) last[x] = factor * (last[x] + pole * before[x]);
  }
  for (int y = height - 2; y >= 0; --y) {
    float* __restrict here = row(y);
    const float* __restrict after = row(y + 1);
    for (int x = 0; x < width; ++x) here[x] = pole * (after[x] - here[x]);
  }
}

inline void resampleRow(const float* coefficients, int stride, int width, int height, const float* table,
                        const float* places, int count, float* out) {
  for (int i = 0; i < count; ++i) {
    const float x = places[2 * i], y = places[2 * i + 1];
    if (!(x > -1.0f && y > -1.0f && x < float(width) && y < float(height))) {
      out[i] = 0;
      continue;
    }
    const int column = int(x + 1.0f) - 1, row = int(y + 1.0f) - 1;  // rounds down from -1 on
    const float* __restrict along = table + kLanes * int((x - float(column)) * float(kSteps) + 0.5f);
    const float* __restrict down = table + kLanes * int((y - float(row)) * float(kSteps) + 0.5f);
    const float* at = coefficients + std::int64_t(row - 2) * stride + column - 2;
    float sum[kLanes] = {};
    for (int v = 0; v < kTaps; ++v) {
      const float* __restrict line = at + std::int64_t(v) * stride;
      const float weight = down[v];
#pragma GCC unroll 1
      for (int u = 0; u < kLanes; ++u) sum[u] += weight * line[u];
    }
    float total = 0;
    for (int u = 0; u < kTaps; ++u) total += along[u] * sum[u];
    out[i] = total;
  }
}
