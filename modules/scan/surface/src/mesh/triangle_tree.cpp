#include "triangle_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <numeric>

#include "facenav/geometry/nearest_on_triangle.h"

namespace facenav::surface {
namespace {

using Eigen::Array4f;
using Eigen::Vector3f;

constexpr int kLeaf = 6;        // most triangles in a leaf
constexpr float kSame = 1e-5f;  // relative, of the squared distance: two triangles share one nearest place

float squaredToBox(const Array4f& low, const Array4f& high, const Array4f& p) {
  return (low - p).max(p - high).max(Array4f::Zero()).square().sum();
}

Array4f padded(const Vector3f& v) { return {v.x(), v.y(), v.z(), 0.f}; }

constexpr float kUnknown = -1;  // facing not yet computed

}  // namespace

TriangleTree::TriangleTree(const TriangleMesh& mesh) : triangle_(mesh.triangles.size()) {
  const std::size_t n = mesh.triangles.size();
  std::iota(triangle_.begin(), triangle_.end(), 0);
  std::vector<Vector3f> middle(n);
  corners_.resize(n);
  for (std::size_t t = 0; t < n; ++t) {
    const auto& v = mesh.triangles[t];
    corners_[t] = {mesh.vertices_mm[v[0]].cast<float>(), mesh.vertices_mm[v[1]].cast<float>(),
                   mesh.vertices_mm[v[2]].cast<float>()};
    middle[t] = (corners_[t].a + corners_[t].b + corners_[t].c) / 3;
  }
  nodes_.reserve(n);
  nodes_.push_back({Array4f::Zero(), Array4f::Zero(), 0, int(n)});
  if (n > 0) split(0, middle);
  std::vector<Corners> ordered(n);
  slot_.resize(n);
  for (std::size_t s = 0; s < n; ++s) ordered[s] = corners_[triangle_[s]], slot_[triangle_[s]] = int(s);
  corners_.swap(ordered);
}

void TriangleTree::split(int node, std::vector<Vector3f>& middle) {
  Vector3f low = Vector3f::Constant(std::numeric_limits<float>::max()), high = -low;
  Vector3f low_middle = low, high_middle = high;
  const int first = nodes_[node].first, count = nodes_[node].count;
  for (int s = first; s < first + count; ++s) {
    const Corners& t = corners_[triangle_[s]];
    low = low.cwiseMin(t.a).cwiseMin(t.b).cwiseMin(t.c),
    high = high.cwiseMax(t.a).cwiseMax(t.b).cwiseMax(t.c);
    low_middle = low_middle.cwiseMin(middle[triangle_[s]]);
    high_middle = high_middle.cwiseMax(middle[triangle_[s]]);
  }
  nodes_[node].low = padded(low), nodes_[node].high = padded(high);
  if (count <= kLeaf) return;
  int axis = 0;
  (high_middle - low_middle).maxCoeff(&axis);
  const auto begin = triangle_.begin() + first, half = begin + count / 2;
  std::nth_element(begin, half, begin + count,
                   [&](int a, int b) { return middle[a][axis] < middle[b][axis]; });
  const int child = int(nodes_.size());
  const Array4f zero = Array4f::Zero();
  nodes_.push_back({zero, zero, first, count / 2});
  nodes_.push_back({zero, zero, first + count / 2, count - count / 2});
  nodes_[node].first = child, nodes_[node].count = 0;
  split(child, middle);
  split(child + 1, middle);
}

float TriangleTree::facing(int slot, const Vector3f& p, const Vector3f& at) const {
  const Corners& t = corners_[slot];
  return std::abs((t.b - t.a).cross(t.c - t.a).normalized().dot(p - at));
}

void TriangleTree::consider(int slot, const Vector3f& p, NearestPlace& best, float& best_facing) const {
  const Corners& t = corners_[slot];
  const Vector3f at = nearestOnTriangle(p, t.a, t.b, t.c).point;
  const float squared = (p - at).squaredNorm();
  if (squared > best.squared_mm2 * (1 + kSame)) return;
  if (squared >= best.squared_mm2 * (1 - kSame)) {
    if (best_facing == kUnknown) best_facing = facing(slot_[std::size_t(best.triangle)], p, best.point_mm);
    const float faces = facing(slot, p, at);
    if (faces <= best_facing) return;
    best_facing = faces;
  } else {
    best_facing = kUnknown;  // computed when another triangle is equally near
  }
  best = {at, std::min(squared, best.squared_mm2), triangle_[slot]};
}

void TriangleTree::visit(int node, const Array4f& p, NearestPlace& best, float& best_facing) const {
  const Node& n = nodes_[node];
  if (n.count > 0) {
    for (int s = n.first; s < n.first + n.count; ++s) consider(s, p.head<3>().matrix(), best, best_facing);
    return;
  }
  int nearer = n.first, farther = n.first + 1;
  float to_nearer = squaredToBox(nodes_[nearer].low, nodes_[nearer].high, p),
        to_farther = squaredToBox(nodes_[farther].low, nodes_[farther].high, p);
  if (to_farther < to_nearer) std::swap(nearer, farther), std::swap(to_nearer, to_farther);
  if (to_nearer <= best.squared_mm2 * (1 + kSame)) visit(nearer, p, best, best_facing);
  if (to_farther <= best.squared_mm2 * (1 + kSame)) visit(farther, p, best, best_facing);
}

NearestPlace TriangleTree::nearest(const Vector3f& p_mm, std::optional<int> near) const {
  NearestPlace best;
  best.squared_mm2 = std::numeric_limits<float>::max() / 2;
  float best_facing = kUnknown;
  if (near) consider(slot_[std::size_t(*near)], p_mm, best, best_facing);
  visit(0, padded(p_mm), best, best_facing);
  return best;
}

}  // namespace facenav::surface
