#include <algorithm>
#include <cmath>

#include "facenav/core/simd.h"
#include "facenav/registration/scalp_field.h"
#include "point_kernel.h"

namespace facenav::registration::point {
namespace {

/// Loops without branches, so that compilers process four points at once.
void markCounterparts(const Points& points, int first, const View& view, Block& block) {
  const int n = block.count;
  for (int i = 0; i < n; ++i) {
    const float cx = view.t[0] - block.at_mm[0][i], cy = view.t[1] - block.at_mm[1][i],
                cz = view.t[2] - block.at_mm[2][i];
    const float nx = block.normal[0][i], ny = block.normal[1][i], nz = block.normal[2][i];
    const float facing = nx * cx + ny * cy + nz * cz;
    const float least =
        kGrazing_cos * kGrazing_cos * (cx * cx + cy * cy + cz * cz) * (nx * nx + ny * ny + nz * nz);
    const float grazing = facing * std::abs(facing) > least ? 1.0f : 0.0f;
    block.is_valid[i] = block.residual_mm[i] < kNoSkin_mm ? grazing : 0.0f;  // NaN: no skin
  }
  if (!points.normal[0]) return;
  const float *u = points.normal[0] + first, *v = points.normal[1] + first, *w = points.normal[2] + first;
  for (int i = 0; i < n; ++i) {
    float agree = 0.0f;
    for (int a = 0; a < 3; ++a)
      agree += block.normal[a][i] * (view.r[a][0] * u[i] + view.r[a][1] * v[i] + view.r[a][2] * w[i]);
    block.is_valid[i] = agree > kNormalsAgree_cos ? block.is_valid[i] : 0.0f;
  }
}

void measure(const FieldGrids& grids, const Points& points, int first, int count, const View& view,
             bool is_fine, Block& block) {
  block.count = count;
  const float *x = points.at_mm[0] + first, *y = points.at_mm[1] + first, *z = points.at_mm[2] + first;
  for (int a = 0; a < 3; ++a)
    for (int i = 0; i < count; ++i)
      block.at_mm[a][i] = view.r[a][0] * x[i] + view.r[a][1] * y[i] + view.r[a][2] * z[i] + view.t[a];
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3f query(block.at_mm[0][i], block.at_mm[1][i], block.at_mm[2][i]);
    const FieldSample sample = is_fine ? sampleFine(grids, query) : sampleCoarse(grids, query);
    block.residual_mm[i] = sample.distance_mm;
    for (int a = 0; a < 3; ++a) block.normal[a][i] = sample.gradient[a];
  }
  markCounterparts(points, first, view, block);
}

using Column = float[kBlock];

Sums sumProducts(const Column (&row)[7], const Column& weight) {
  constexpr int kLanes = 4;
  Sums sums{};
  float* product = sums.products;
  for (int r = 0; r < 7; ++r) {
    Column weighted;
    for (int i = 0; i < kBlock; ++i) weighted[i] = row[r][i] * weight[i];
    for (int c = 0; c <= r; ++c) {
      float lane[kLanes] = {};
      for (int i = 0; i < kBlock; i += kLanes)
        for (int l = 0; l < kLanes; ++l) lane[l] += weighted[i + l] * row[c][i + l];
      *product++ = lane[0] + lane[1] + lane[2] + lane[3];
    }
  }
  for (int i = 0; i < kBlock; ++i) sums.weight += weight[i];
  return sums;
}

Sums sum(const Block& block, const Points& points, int first, const Loss& loss) {
  const float outside = 1.0f / loss.outside_mm, inside = 1.0f / loss.inside_mm;
  Column row[7], weight;
  for (int i = 0; i < block.count; ++i) {
    // Residual and normal may be NaN if there is no counterpart. They are set to zero, since NaN times zero
    // is NaN.
    const bool is_valid = block.is_valid[i] > 0;
    const float residual = is_valid ? block.residual_mm[i] : 0.0f;
    const float u = residual * (residual > 0 ? outside : inside), v = std::max(0.0f, 1.0f - u * u);
    weight[i] = is_valid ? v * v : 0.0f;
    const float x = is_valid ? block.at_mm[0][i] - loss.pivot_mm[0] : 0.0f,
                y = is_valid ? block.at_mm[1][i] - loss.pivot_mm[1] : 0.0f,
                z = is_valid ? block.at_mm[2][i] - loss.pivot_mm[2] : 0.0f;
    const float nx = is_valid ? block.normal[0][i] : 0.0f, ny = is_valid ? block.normal[1][i] : 0.0f,
                nz = is_valid ? block.normal[2][i] : 0.0f;
    row[0][i] = y * nz - z * ny, row[1][i] = z * nx - x * nz, row[2][i] = x * ny - y * nx;
    row[3][i] = nx, row[4][i] = ny, row[5][i] = nz, row[6][i] = residual;
  }
  if (points.weight)
    for (int i = 0; i < block.count; ++i) weight[i] *= points.weight[first + i];
  for (int i = block.count; i < kBlock; ++i) {
    weight[i] = 0.0f;
    for (auto& r : row) r[i] = 0.0f;
  }
  return sumProducts(row, weight);
}

}  // namespace

const Kernel& baseKernel() {
  static const Kernel base{measure, sum};
  return base;
}

const Kernel& kernel() {
  static const Kernel& chosen = chooseKernel(baseKernel, avx2Kernel);
  return chosen;
}

}  // namespace facenav::registration::point
