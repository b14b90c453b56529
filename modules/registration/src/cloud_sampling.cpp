#include "cloud_sampling.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <unordered_set>

namespace facenav::registration {

std::vector<int> thinOut(const PointCloud<Camera>& cloud, double cell_mm, std::size_t most,
                         std::uint32_t seed) {
  std::vector<int> order;
  for (std::size_t p = 0; p < cloud.size(); ++p)
    if (cloud.points_mm[p].allFinite() && cloud.points_mm[p].cwiseAbs().maxCoeff() < 1e5)
      order.push_back(int(p));
  std::mt19937 random(seed);
  for (std::size_t p = order.size(); p > 1; --p) std::swap(order[p - 1], order[random() % p]);
  std::vector<int> chosen;
  for (;; cell_mm *= 1.2) {
    std::unordered_set<std::int64_t> taken;
    chosen.clear();
    for (const int p : order) {
      const Eigen::Vector3d cell = (cloud.points_mm[p] / cell_mm).array().floor();
      const auto code = (std::int64_t(cell[0]) & 0x1fffff) | (std::int64_t(cell[1]) & 0x1fffff) << 21 |
                        (std::int64_t(cell[2]) & 0x1fffff) << 42;
      if (taken.insert(code).second) chosen.push_back(p);
    }
    if (chosen.size() <= most) return chosen;
  }
}

PointCloud<Camera> pick(const PointCloud<Camera>& cloud, const std::vector<int>& indices) {
  PointCloud<Camera> out;
  const bool has_normals = cloud.normals.size() == cloud.size();
  for (const int p : indices) {
    out.points_mm.push_back(cloud.points_mm[p]);
    if (has_normals) out.normals.push_back(cloud.normals[p]);
  }
  return out;
}

}  // namespace facenav::registration
