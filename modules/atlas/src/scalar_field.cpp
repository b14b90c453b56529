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

/// The same across `count` rows of `width` values, rows `stride` apart: whole rows at a time.
void meanAcross(const float* in, float* out, int count, std::size_t stride, int width, int radius) {
  std::vector<double> sum(width, 0.0);
  int n = 0;
  const auto add = [&](int row, double sign) {
    const float* from = in + row * stride;
    for (int i = 0; i < width; ++i) sum[i] += sign * double(from[i]);
    n += sign > 0 ? 1 : -1;
  };
  for (int t = 0; t < std::min(radius, count); ++t) add(t, 1);
  for (int t = 0; t < count; ++t) {
    if (t + radius < count) add(t + radius, 1);
    if (t - radius - 1 >= 0) add(t - radius - 1, -1);
    float* to = out + t * stride;
    const double share = 1.0 / n;
    for (int i = 0; i < width; ++i) to[i] = float(share * sum[i]);
  }
}

}  // namespace

float sample(const ScalarField& f, const Eigen::Vector3f& at) {
  int low[3];
  float part[3];
  for (int a = 0; a < 3; ++a) {
    const float x = std::clamp(at[a], 0.f, float(f.size[a] - 1));
    low[a] = std::min(int(x), std::max(0, f.size[a] - 2));
    part[a] = x - float(low[a]);
  }
  const std::size_t di = f.size[0] > 1, dj = f.size[1] > 1 ? f.size[0] : 0,
                    dk = f.size[2] > 1 ? std::size_t(f.size[0]) * f.size[1] : 0;
  const float* v = &f.values[f.index(low[0], low[1], low[2])];
  const auto row = [&](const float* p) { return p[0] + part[0] * (p[di] - p[0]); };
  const auto plane = [&](const float* p) {
    const float a = row(p);
    return a + part[1] * (row(p + dj) - a);
  };
  const float a = plane(v);
  return a + part[2] * (plane(v + dk) - a);
}

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
  for (int pass = 0; pass < passes; ++pass) field = boxMean(field, 1);
  return field;
}

Eigen::Vector3f gradientAt(const ScalarField& f, int i, int j, int k) {
  const int n[3] = {i, j, k};
  Eigen::Vector3f g;
  for (int a = 0; a < 3; ++a) {
    int low[3] = {i, j, k}, high[3] = {i, j, k};
    low[a] = std::max(0, n[a] - 1);
    high[a] = std::min(f.size[a] - 1, n[a] + 1);
    const int span = std::max(1, high[a] - low[a]);
    g[a] = (f.at(high[0], high[1], high[2]) - f.at(low[0], low[1], low[2])) / float(span);
  }
  return g;
}

}  // namespace facenav::atlas
