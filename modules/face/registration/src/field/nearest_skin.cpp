#include "nearest_skin.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "facenav/core/error.h"
#include "facenav/geometry/nearest_on_triangle.h"

namespace facenav::registration {
namespace {

constexpr double kNode_mm = 4.0;

}  // namespace

NearestSkin::NearestSkin(const SkinModel& skin) : skin_(&skin) {
  if (skin.points.empty() || skin.points.normals.size() != skin.points.size() || skin.triangles.empty())
    throw Error("not aligned: the skin model has no surface", {}, "run 'facenav prepare' again");
  low_ = high_ = vertices().front();
  for (const auto& v : vertices()) low_ = low_.cwiseMin(v), high_ = high_.cwiseMax(v);
  linkVertices();
  fillNodes();
}

void NearestSkin::linkVertices() {
  std::vector<std::pair<int, int>> directed, corner;
  directed.reserve(3 * skin_->triangles.size());
  corner.reserve(3 * skin_->triangles.size());
  for (std::size_t t = 0; t < skin_->triangles.size(); ++t)
    for (int c = 0; c < 3; ++c) {
      directed.emplace_back(skin_->triangles[t][c], skin_->triangles[t][(c + 1) % 3]);
      corner.emplace_back(skin_->triangles[t][c], int(t));
    }
  corner_triangles_ = withoutRepetitions(groupedByOwner(corner, vertices().size()));
  // An edge without its opposite lies on the surface's border.
  const Grouped ahead = groupedByOwner(directed, vertices().size());
  on_border_.assign(vertices().size(), false);
  std::vector<std::pair<int, int>> both;
  both.reserve(2 * directed.size());
  for (const auto& [a, b] : directed) {
    if (!std::binary_search(ahead.all.begin() + ahead.first[b], ahead.all.begin() + ahead.first[b + 1], a))
      on_border_[a] = on_border_[b] = true;
    both.emplace_back(a, b);
    both.emplace_back(b, a);
  }
  neighbours_ = withoutRepetitions(groupedByOwner(both, vertices().size()));
}

void NearestSkin::fillNodes() {
  origin_ = low_ - Eigen::Vector3d::Constant(kMargin_mm);
  for (int a = 0; a < 3; ++a) size_[a] = int(std::ceil((high_[a] - low_[a] + 2 * kMargin_mm) / kNode_mm)) + 1;
  node_.assign(std::size_t(size_[0]) * size_[1] * size_[2], -1);
  std::vector<float> nearest(node_.size(), std::numeric_limits<float>::max());
  for (std::size_t v = 0; v < vertices().size(); ++v) {
    if (corner_triangles_.first[v] == corner_triangles_.first[v + 1]) continue;  // belongs to no triangle
    const Eigen::Vector3d at = (vertices()[v] - origin_) / kNode_mm;
    const Eigen::Vector3i low = at.array().floor().cast<int>();
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3i n = low + Eigen::Vector3i(corner & 1, corner >> 1 & 1, corner >> 2);
      const std::size_t node = n[0] + std::size_t(size_[0]) * (n[1] + std::size_t(size_[1]) * n[2]);
      const float d = float((at - n.cast<double>()).squaredNorm());
      if (d < nearest[node]) nearest[node] = d, node_[node] = int(v);
    }
  }
  std::vector<std::array<int, 3>> before;
  for (int k = -1; k <= 0; ++k)
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i)
        if (k * 9 + j * 3 + i < 0) before.push_back({i, j, k});
  propagate(before, false);
  propagate(before, true);
}

void NearestSkin::propagate(const std::vector<std::array<int, 3>>& offsets, bool is_backward) {
  const auto squared = [&](int vertex, const Eigen::Vector3d& p) {
    return (vertices()[vertex] - p).squaredNorm();
  };
  const int sign = is_backward ? -1 : 1;
  for (int kk = 0; kk < size_[2]; ++kk)
    for (int jj = 0; jj < size_[1]; ++jj)
      for (int ii = 0; ii < size_[0]; ++ii) {
        const int i = is_backward ? size_[0] - 1 - ii : ii, j = is_backward ? size_[1] - 1 - jj : jj;
        const int k = is_backward ? size_[2] - 1 - kk : kk;
        const std::size_t node = i + std::size_t(size_[0]) * (j + std::size_t(size_[1]) * k);
        const Eigen::Vector3d p = origin_ + kNode_mm * Eigen::Vector3d(i, j, k);
        int best = node_[node];
        double distance = best >= 0 ? squared(best, p) : std::numeric_limits<double>::max();
        for (const auto& o : offsets) {
          const int a = i + sign * o[0], b = j + sign * o[1], c = k + sign * o[2];
          if (a < 0 || b < 0 || c < 0 || a >= size_[0] || b >= size_[1] || c >= size_[2]) continue;
          const int other = node_[a + std::size_t(size_[0]) * (b + std::size_t(size_[1]) * c)];
          if (other < 0 || other == best) continue;
          const double d = squared(other, p);
          if (d < distance) distance = d, best = other;
        }
        node_[node] = best;
      }
}

int NearestSkin::nodeVertex(const Eigen::Vector3d& p) const {
  const Eigen::Vector3d at = (p - origin_) / kNode_mm;
  std::array<int, 3> n;
  for (int a = 0; a < 3; ++a) n[a] = int(std::clamp(std::round(at[a]), 0.0, size_[a] - 1.0));
  return node_[n[0] + std::size_t(size_[0]) * (n[1] + std::size_t(size_[1]) * n[2])];
}

int NearestSkin::nearestVertex(const Eigen::Vector3d& p) const {
  int vertex = nodeVertex(p);
  double nearest = (vertices()[vertex] - p).squaredNorm();
  for (bool has_moved = true; has_moved;) {
    has_moved = false;
    const int at = vertex;
    for (int e = neighbours_.first[at]; e < neighbours_.first[at + 1]; ++e) {
      const double d = (vertices()[neighbours_.all[e]] - p).squaredNorm();
      if (d < nearest) nearest = d, vertex = neighbours_.all[e], has_moved = true;
    }
  }
  return vertex;
}

bool NearestSkin::isBeyondScan(const Eigen::Vector3d& p) const {
  for (const auto& [point, normal] : skin_->field_of_view)
    if ((p - point.mm).dot(normal.v) > 0) return true;
  return false;
}

SkinContact NearestSkin::nearest(const Eigen::Vector3d& p) const {
  SkinContact contact;
  contact.vertex = nearestVertex(p);
  contact.is_on_border = on_border_[contact.vertex];
  contact.is_beyond_scan = isBeyondScan(p);
  double nearest = std::numeric_limits<double>::max();
  for (int e = corner_triangles_.first[contact.vertex]; e < corner_triangles_.first[contact.vertex + 1];
       ++e) {
    const Eigen::Vector3i& t = skin_->triangles[corner_triangles_.all[e]];
    const Eigen::Vector3d w =
        nearestOnTriangle(p, vertices()[t[0]], vertices()[t[1]], vertices()[t[2]]).weights;
    const Eigen::Vector3d q = w[0] * vertices()[t[0]] + w[1] * vertices()[t[1]] + w[2] * vertices()[t[2]];
    const double d = (p - q).squaredNorm();
    if (d >= nearest) continue;
    nearest = d;
    contact.closest_mm = q;
    contact.normal = w[0] * normals()[t[0]] + w[1] * normals()[t[1]] + w[2] * normals()[t[2]];
  }
  contact.normal.normalize();
  contact.distance_mm = std::sqrt(nearest) * (contact.normal.dot(p - contact.closest_mm) < 0 ? -1.0 : 1.0);
  return contact;
}

}  // namespace facenav::registration
