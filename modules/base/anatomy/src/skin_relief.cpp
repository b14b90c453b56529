#include "facenav/anatomy/skin_relief.h"

#include <algorithm>
#include <cmath>

namespace facenav::anatomy {
namespace {

using Eigen::Vector3d;

struct View {
  int across, up, toward;
  double sign;  // direction of `toward` along its axis
};
View viewOf(Side side) {
  if (side == Side::front) return {0, 2, 1, 1.0};
  return {1, 2, 0, side == Side::right ? 1.0 : -1.0};
}

void fillTriangle(SkinRelief& relief, const std::array<Vector3d, 3>& p) {  // across, up, height
  const auto [low_u, high_u] = std::minmax({p[0].x(), p[1].x(), p[2].x()});
  const auto [low_v, high_v] = std::minmax({p[0].y(), p[1].y(), p[2].y()});
  const Eigen::Vector2d a = (p[1] - p[0]).head<2>(), b = (p[2] - p[0]).head<2>();
  const double area = a.x() * b.y() - a.y() * b.x();
  if (std::abs(area) < 1e-9) return;
  for (int row = int(std::ceil(low_v - relief.bottom_mm)); row <= int(high_v - relief.bottom_mm); ++row)
    for (int column = int(std::ceil(low_u - relief.left_mm)); column <= int(high_u - relief.left_mm);
         ++column) {
      if (row < 0 || column < 0 || row >= relief.rows || column >= relief.columns) continue;
      const Eigen::Vector2d c(relief.left_mm + column - p[0].x(), relief.bottom_mm + row - p[0].y());
      const double s = (c.x() * b.y() - c.y() * b.x()) / area, t = (a.x() * c.y() - a.y() * c.x()) / area;
      if (s < -1e-9 || t < -1e-9 || s + t > 1 + 1e-9) continue;
      float& height = relief.height_mm[std::size_t(row) * relief.columns + column];
      height = std::max(height, float(p[0].z() + s * (p[1].z() - p[0].z()) + t * (p[2].z() - p[0].z())));
    }
}

}  // namespace

std::optional<double> SkinRelief::at(double across_mm, double up_mm) const {
  const double u = across_mm - left_mm, v = up_mm - bottom_mm;
  const int i = int(std::floor(u)), j = int(std::floor(v));
  const float h[4] = {cell(i, j), cell(i + 1, j), cell(i, j + 1), cell(i + 1, j + 1)};
  if (*std::min_element(h, h + 4) <= kNone) return std::nullopt;
  const double s = u - i, t = v - j;
  return (1 - t) * ((1 - s) * h[0] + s * h[1]) + t * ((1 - s) * h[2] + s * h[3]);
}

SkinRelief reliefFrom(Side side, const std::vector<Vector3d>& head_mm,
                      const std::vector<Eigen::Vector3i>& triangles) {
  const View view = viewOf(side);
  Vector3d low = head_mm.front(), high = low;
  for (const auto& v : head_mm) low = low.cwiseMin(v), high = high.cwiseMax(v);
  SkinRelief relief;
  relief.across_axis = view.across;
  relief.up_axis = view.up;
  relief.left_mm = std::floor(low[view.across]);
  relief.bottom_mm = std::floor(low[view.up]);
  relief.columns = int(high[view.across] - relief.left_mm) + 2;
  relief.rows = int(high[view.up] - relief.bottom_mm) + 2;
  relief.height_mm.assign(std::size_t(relief.columns) * relief.rows, SkinRelief::kNone);
  for (const auto& triangle : triangles) {
    std::array<Vector3d, 3> p;
    for (int k = 0; k < 3; ++k) {
      const Vector3d& v = head_mm[std::size_t(triangle[k])];
      p[std::size_t(k)] = {v[view.across], v[view.up], view.sign * v[view.toward]};
    }
    fillTriangle(relief, p);
  }
  return relief;
}

SkinRelief smoothed(const SkinRelief& relief, double sigma_mm) {
  const int radius = int(std::ceil(2.5 * sigma_mm));
  std::vector<float> kernel;
  for (int k = -radius; k <= radius; ++k)
    kernel.push_back(float(std::exp(-0.5 * k * k / (sigma_mm * sigma_mm))));
  const auto pass = [&](const SkinRelief& in, int du, int dv) {
    SkinRelief out = in;
    for (int row = 0; row < in.rows; ++row)
      for (int column = 0; column < in.columns; ++column) {
        if (in.cell(column, row) <= SkinRelief::kNone) continue;
        float sum = 0, weight = 0;
        for (int k = -radius; k <= radius; ++k) {
          const float h = in.cell(column + k * du, row + k * dv);
          if (h <= SkinRelief::kNone) continue;
          sum += kernel[std::size_t(k + radius)] * h;
          weight += kernel[std::size_t(k + radius)];
        }
        out.height_mm[std::size_t(row) * in.columns + column] = sum / weight;
      }
    return out;
  };
  return pass(pass(relief, 1, 0), 0, 1);
}

}  // namespace facenav::anatomy
