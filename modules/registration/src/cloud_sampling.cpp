#include "cloud_sampling.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace facenav::registration {
namespace {

/// The set of cubes that are taken: open addressing, never more than half full.
class CubeSet {
 public:
  explicit CubeSet(std::size_t most) {
    std::size_t size = 64;
    while (size < 2 * most) size *= 2;
    slots_.assign(size, kFree);
  }
  bool insert(std::uint64_t key) {
    std::size_t at = std::size_t((key * 0x9e3779b97f4a7c15ull) >> 20) & (slots_.size() - 1);
    for (; slots_[at] != kFree; at = (at + 1) & (slots_.size() - 1))
      if (slots_[at] == key) return false;
    slots_[at] = key;
    return true;
  }

 private:
  static constexpr std::uint64_t kFree = ~0ull;
  std::vector<std::uint64_t> slots_;
};

std::uint64_t cubeOf(const Eigen::Vector3d& p_mm, double per_mm) {
  const auto cell = [&](double x) { return std::uint64_t(std::int64_t(x * per_mm + 1048576.0)) & 0x1fffff; };
  return cell(p_mm.x()) | cell(p_mm.y()) << 21 | cell(p_mm.z()) << 42;
}

/// A stride that visits all of 0 .. n-1 in an order that looks scattered.
std::size_t scatteredStride(std::size_t n) {
  std::size_t stride = std::size_t(0.6180339887 * double(n)) | 1;
  while (std::gcd(stride, n) != 1) ++stride;
  return stride;
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
    CubeSet taken(std::min(of.size(), most + 1));
    std::size_t at = 0, visited = 0;
    for (; visited < of.size() && chosen.size() <= most; ++visited) {
      if (taken.insert(cubeOf(cloud.points_mm[std::size_t(of[at])], 1.0 / cell_mm))) chosen.push_back(of[at]);
      at += stride;
      if (at >= of.size()) at -= of.size();
    }
    if (chosen.size() <= most) return chosen;
    // So many after part of the points: of a surface, cubes as much larger hold the number.
    cell_mm *= std::max(1.2, 0.9 * std::sqrt(double(of.size()) / double(visited)));
  }
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
