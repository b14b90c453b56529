#include "cloud_sampling.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cube_numbers.h"

namespace facenav::registration {
namespace {

/// A stride that visits all of 0 .. n-1 in a scattered order.
std::size_t scatteredStride(std::size_t n) {
  std::size_t stride = std::size_t(0.6180339887 * double(n)) | 1;
  while (std::gcd(stride, n) != 1) ++stride;
  return stride;
}

/// Mean number of points n per cube at which the occupied cubes number `share` of the points, for points at
/// random on a surface: (1 - exp(-n)) / n = share.
double fillingAt(double share) {
  double low = 0, high = 50;
  for (int halving = 0; halving < 24; ++halving) {
    const double n = 0.5 * (low + high);
    (1 - std::exp(-n) > share * n ? low : high) = n;
  }
  return high;
}

}  // namespace

std::vector<int> finitePoints(const PointCloud<Camera>& cloud) {
  std::vector<int> finite;
  finite.reserve(cloud.size());
  for (std::size_t p = 0; p < cloud.size(); ++p)
    if (cloud.points_mm[p].allFinite() && cloud.points_mm[p].cwiseAbs().maxCoeff() < 1e5)
      finite.push_back(int(p));
  return finite;
}

std::vector<int> thinOut(const PointCloud<Camera>& cloud, const std::vector<int>& of, double cell_mm,
                         std::size_t most) {
  if (of.empty()) return {};
  const std::size_t stride = scatteredStride(of.size());
  for (;;) {
    std::vector<int> chosen;
    chosen.reserve(std::min(of.size(), most + 1));
    CubeNumbers taken(cell_mm, std::min(of.size(), most + 1));
    std::size_t at = 0, visited = 0;
    for (; visited < of.size() && chosen.size() <= most; ++visited) {
      const auto cube = std::size_t(taken.of(cloud.points_mm[std::size_t(of[at])].cast<float>()));
      if (cube == chosen.size()) chosen.push_back(of[at]);
      at += stride;
      if (at >= of.size()) at -= of.size();
    }
    if (chosen.size() <= most) return chosen;
    // The number of occupied cubes of a surface falls with the square of the cell. Points in a regular
    // pattern occupy more cubes than this formula predicts.
    const double seen = double(visited) / double(of.size());
    const double growth = std::sqrt(seen * fillingAt(0.95 * double(most) / double(of.size())) /
                                    fillingAt(double(most) / double(visited)));
    cell_mm *= std::clamp(growth, 1.05, std::max(1.3, 1 / std::sqrt(seen)));
  }
}

std::vector<int> someOf(std::vector<int> points, std::size_t most) {
  if (points.size() <= most) return points;
  for (std::size_t c = 0; c < most; ++c) points[c] = points[c * points.size() / most];
  points.resize(most);
  return points;
}

std::vector<int> thinOut(const PointCloud<Camera>& cloud, double cell_mm, std::size_t most) {
  return thinOut(cloud, finitePoints(cloud), cell_mm, most);
}

PointCloud<Camera> pick(const PointCloud<Camera>& cloud, const std::vector<int>& indices) {
  PointCloud<Camera> out;
  const bool has_normals = cloud.normals.size() == cloud.size();
  for (const int p : indices) {
    out.points_mm.push_back(cloud.points_mm[std::size_t(p)]);
    if (has_normals) out.normals.push_back(cloud.normals[std::size_t(p)]);
  }
  return out;
}

}  // namespace facenav::registration
