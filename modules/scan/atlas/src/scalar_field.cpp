#include "scalar_field.h"

#include <algorithm>
#include <cmath>

namespace facenav::atlas {
namespace {

/// Running mean along a line of `count` values.
void meanAlong(const float* in, float* out, int count, int radius) {
  double sum = 0;
  int n = 0;
  for (int t = 0; t < std::min(radius, count); ++t) sum += in[t], ++n;
  for (int t = 0; t < count; ++t) {
    if (t + radius < count) sum += in[t + radius], ++n;
    if (t - radius - 1 >= 0) sum -= in[t - radius - 1], --n;
    out[t] = float(sum / n);
  }
}

/// Running mean across `count` rows of `width` values (distance `stride`), whole rows at a time.
void meanAcross(const float* in, float* out, int count, std::size_t stride, int width, int radius) {
  std::vector<float> sum(width, 0.f);
  int n = 0;
  const auto add = [&](int row, float sign) {
    const float* from = in + row * stride;
    for (int i = 0; i < width; ++i) sum[i] += sign * from[i];
    n += sign > 0 ? 1 : -1;
  };
  for (int t = 0; t < std::min(radius, count); ++t) add(t, 1);
  for (int t = 0; t < count; ++t) {
    if (t + radius < count) add(t + radius, 1);
    if (t - radius - 1 >= 0) add(t - radius - 1, -1);
    float* to = out + t * stride;
    const float share = 1.f / float(n);
    for (int i = 0; i < width; ++i) to[i] = share * sum[i];
  }
}

/// Mean of a value and its two neighbours in a row; at the ends, of the two values that exist.
void meanOfThree(const float* in, float* out, int count) {
  constexpr float kThird = 1.f / 3;
  if (count == 1) {
    out[0] = in[0];
    return;
  }
  out[0] = 0.5f * (in[0] + in[1]);
  for (int i = 1; i + 1 < count; ++i) out[i] = kThird * (in[i - 1] + in[i] + in[i + 1]);
  out[count - 1] = 0.5f * (in[count - 2] + in[count - 1]);
}

/// Mean of three rows, value by value; `before` or `after` is null at the grid's end.
void meanOfRows(const float* before, const float* here, const float* after, float* out, std::size_t width) {
  constexpr float kThird = 1.f / 3;
  if (before && after)
    for (std::size_t i = 0; i < width; ++i) out[i] = kThird * (before[i] + here[i] + after[i]);
  else if (const float* other = before ? before : after)
    for (std::size_t i = 0; i < width; ++i) out[i] = 0.5f * (here[i] + other[i]);
  else
    std::copy_n(here, width, out);
}

}  // namespace

float sample(const ScalarField& f, const Eigen::Vector3f& at) { return Cell(f.size, at).of(f); }

ScalarField boxMean(const ScalarField& field, int radius) {
  const auto [ni, nj, nk] = field.size;
  ScalarField along_ij(field.size);
  forSlices(nk, [&, ni = ni, nj = nj](int k) {
    std::vector<float> rows(std::size_t(ni) * nj);
    for (int j = 0; j < nj; ++j)
      meanAlong(&field.values[field.index(0, j, k)], &rows[std::size_t(j) * ni], ni, radius);
    meanAcross(rows.data(), &along_ij.values[along_ij.index(0, 0, k)], nj, ni, ni, radius);
  });
  ScalarField mean(field.size);
  forSlices(nj, [&, ni = ni, nj = nj, nk = nk](int j) {
    const std::size_t first = field.index(0, j, 0);
    meanAcross(&along_ij.values[first], &mean.values[first], nk, std::size_t(ni) * nj, ni, radius);
  });
  return mean;
}

ScalarField smoothed(ScalarField field, int passes) {
  const auto [ni, nj, nk] = field.size;
  const std::size_t row = ni, slab = row * nj;
  ScalarField along(field.size);
  for (int pass = 0; pass < passes; ++pass) {
    forSlices(nk, [&, ni = ni, nj = nj](int k) {
      std::vector<float> rows(slab);
      const float* in = &field.values[k * slab];
      for (int j = 0; j < nj; ++j) meanOfThree(in + j * row, &rows[j * row], ni);
      for (int j = 0; j < nj; ++j)
        meanOfRows(j > 0 ? &rows[(j - 1) * row] : nullptr, &rows[j * row],
                   j + 1 < nj ? &rows[(j + 1) * row] : nullptr, &along.values[k * slab + j * row], row);
    });
    forSlices(nk, [&, nk = nk](int k) {
      meanOfRows(k > 0 ? &along.values[(k - 1) * slab] : nullptr, &along.values[k * slab],
                 k + 1 < nk ? &along.values[(k + 1) * slab] : nullptr, &field.values[k * slab], slab);
    });
  }
  return field;
}

}  // namespace facenav::atlas
