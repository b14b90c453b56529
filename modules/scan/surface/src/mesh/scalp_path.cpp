#include "facenav/surface/scalp_path.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <queue>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"

namespace facenav::surface {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// `count` + 1 points at even distances along the line.
std::vector<Vector3d> evenly(const ScalpPath& path, int count) {
  std::vector<Vector3d> points;
  for (int i = 0; i <= count; ++i) points.push_back(path.atFraction(double(i) / count));
  return points;
}

/// Moves the inner points to the middle of their neighbours and back onto the skin until they rest.
void tighten(std::vector<Vector3d>& points, const ClosestPoint& skin) {
  constexpr int kMostSweeps = 400;
  constexpr double kStill_mm = 1e-4;
  std::vector<std::optional<int>> near(points.size());
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    double most_mm = 0;
    for (int half = 1; half <= 2; ++half)  // odd points, then even ones: each step uses the newest neighbours
      for (std::size_t i = std::size_t(half); i + 1 < points.size(); i += 2) {
        const SurfacePoint place = skin.nearest(Point<Mri>(0.5 * (points[i - 1] + points[i + 1])), near[i]);
        near[i] = place.triangle;
        most_mm = std::max(most_mm, (place.point.mm - points[i]).norm());
        points[i] = place.point.mm;
      }
    if (most_mm < kStill_mm) return;
  }
}

/// Points, in the plane's axes, where the plane through `origin` with the axes `u` and `v` cuts the mesh.
std::vector<Vector2d> cut(const TriangleMesh& mesh, const Vector3d& origin, const Vector3d& u,
                          const Vector3d& v) {
  const Vector3d normal = u.cross(v);
  const double offset = normal.dot(origin);
  std::vector<double> beside;
  for (const Vector3d& p : mesh.vertices_mm) beside.push_back(normal.dot(p) - offset);
  std::vector<Vector2d> points;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const auto i = std::size_t(t[k]), j = std::size_t(t[(k + 1) % 3]);
      const double a = beside[i], b = beside[j];
      if ((a < 0) == (b < 0)) continue;
      const Vector3d p = mesh.vertices_mm[i] - origin, q = mesh.vertices_mm[j] - origin;
      const Vector3d at = p + (q - p) * (a / (a - b));
      points.push_back({u.dot(at), v.dot(at)});
    }
  return points;
}

/// Convex hull, counter-clockwise (Andrew's monotone chain).
std::vector<Vector2d> convexHull(std::vector<Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const Vector2d& a, const Vector2d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  std::vector<Vector2d> hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t first = hull.size();
    for (const Vector2d& p : points) {
      while (hull.size() > first + 1) {
        const Vector2d a = hull.back() - hull[hull.size() - 2], b = p - hull.back();
        if (a.x() * b.y() - a.y() * b.x() > 0) break;
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();  // the first of the other half
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// The tape from (0, 0) to (width, 0) over points with y > 0: the hull's edge between them, the long way.
/// Skin that overhangs the ends (brow, occiput) counts.
std::vector<Vector2d> tautOver(std::vector<Vector2d> points, double width_mm) {
  const Vector2d start(0, 0), end(width_mm, 0);
  points.push_back(start);
  points.push_back(end);
  std::vector<Vector2d> hull = convexHull(std::move(points));
  std::rotate(hull.begin(), std::find(hull.begin(), hull.end(), end), hull.end());
  hull.erase(std::find(hull.begin(), hull.end(), start) + 1, hull.end());
  std::reverse(hull.begin(), hull.end());
  return hull;
}

}  // namespace

ScalpPath::ScalpPath(std::vector<Vector3d> points_mm) : points_mm_(std::move(points_mm)) {
  FACENAV_EXPECT(points_mm_.size() > 1, "a path has two ends");
  from_start_mm_.push_back(0);
  for (std::size_t i = 1; i < points_mm_.size(); ++i)
    from_start_mm_.push_back(from_start_mm_.back() + (points_mm_[i] - points_mm_[i - 1]).norm());
}

/// Index of the end of the piece that contains this distance.
std::size_t ScalpPath::pieceAt(double distance_mm) const {
  const auto after = std::lower_bound(from_start_mm_.begin() + 1, from_start_mm_.end() - 1, distance_mm);
  return std::size_t(after - from_start_mm_.begin());
}

Vector3d ScalpPath::at(double distance_mm) const {
  const std::size_t end = pieceAt(distance_mm);
  const double long_mm = from_start_mm_[end] - from_start_mm_[end - 1];
  const double part = long_mm > 0 ? (distance_mm - from_start_mm_[end - 1]) / long_mm : 0.0;
  const double within = std::min(1.0, std::max(0.0, part));
  return points_mm_[end - 1] + within * (points_mm_[end] - points_mm_[end - 1]);
}

Vector3d ScalpPath::direction(double distance_mm) const {
  const std::size_t end = pieceAt(distance_mm);
  return (points_mm_[end] - points_mm_[end - 1]).normalized();
}

ScalpPaths::ScalpPaths(const TriangleMesh& mesh) : mesh_(mesh), skin_(mesh) {
  std::vector<std::pair<int, int>> edges;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      edges.emplace_back(t[k], t[(k + 1) % 3]);
      edges.emplace_back(t[(k + 1) % 3], t[k]);
    }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  first_.assign(mesh.vertices_mm.size() + 1, 0);
  for (const auto& edge : edges) ++first_[std::size_t(edge.first) + 1], neighbour_.push_back(edge.second);
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
}

/// Dijkstra's shortest way along the edges, guided by the straight distance (A*).
std::vector<int> ScalpPaths::alongEdges(int from, int to) const {
  constexpr double kFar = 1e300;
  const auto& at = mesh_.vertices_mm;
  const Vector3d goal = at[std::size_t(to)];
  std::vector<double> way_mm(at.size(), kFar);
  std::vector<int> before(at.size(), -1);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> open;
  way_mm[std::size_t(from)] = 0;
  open.push({(goal - at[std::size_t(from)]).norm(), from});
  while (!open.empty() && open.top().second != to) {
    const auto [estimate, v] = open.top();
    open.pop();
    const double here = way_mm[std::size_t(v)];
    if (estimate > here + (goal - at[std::size_t(v)]).norm() + 1e-9) continue;  // a shorter way was found
    for (int e = first_[std::size_t(v)]; e < first_[std::size_t(v) + 1]; ++e) {
      const auto n = std::size_t(neighbour_[std::size_t(e)]);
      const double there = here + (at[n] - at[std::size_t(v)]).norm();
      if (there >= way_mm[n]) continue;
      way_mm[n] = there, before[n] = v;
      open.push({there + (goal - at[n]).norm(), int(n)});
    }
  }
  if (way_mm[std::size_t(to)] >= kFar)
    throw Error("no way along the scalp leads from one place to the other", {},
                "the scan cuts the skin between them");
  std::vector<int> way{to};
  while (way.back() != from) way.push_back(before[std::size_t(way.back())]);
  std::reverse(way.begin(), way.end());
  return way;
}

ScalpPath ScalpPaths::shortest(const Vector3d& from_mm, const Vector3d& to_mm) const {
  constexpr double kCoarse_mm = 16, kFine_mm = 2;
  const SurfacePoint from = onSkin(from_mm), to = onSkin(to_mm);
  std::vector<Vector3d> points{from.point.mm};
  const auto corner = [&](const SurfacePoint& p) { return mesh_.triangles[std::size_t(p.triangle)][0]; };
  for (const int v : alongEdges(corner(from), corner(to)))
    points.push_back(mesh_.vertices_mm[std::size_t(v)]);
  points.push_back(to.point.mm);
  ScalpPath path(std::move(points));
  int pieces = std::max(2, int(std::lround(path.length_mm() / kCoarse_mm)));
  for (;; pieces *= 2) {
    auto chain = evenly(path, pieces);
    tighten(chain, skin_);
    path = ScalpPath(std::move(chain));
    if (path.length_mm() / pieces <= kFine_mm) return path;
  }
}

ScalpPath ScalpPaths::tape(const Vector3d& from_mm, const Vector3d& over_mm, const Vector3d& to_mm) const {
  const Vector3d u = (to_mm - from_mm).normalized(), rise = over_mm - from_mm;
  const Vector3d above = rise - rise.dot(u) * u;
  if (!(above.norm() > 1e-6 && u.allFinite()))
    throw Error("a tape needs three places that do not lie on one line");
  const Vector3d v = above.normalized();
  std::vector<Vector2d> skin;
  for (const Vector2d& p : cut(mesh_, from_mm, u, v))
    if (p.y() > 0) skin.push_back(p);
  if (skin.empty()) throw Error("a tape between these places does not lie on the scalp");
  std::vector<Vector3d> points;
  for (const Vector2d& p : tautOver(std::move(skin), (to_mm - from_mm).norm()))
    points.push_back(from_mm + p.x() * u + p.y() * v);
  return ScalpPath(std::move(points));
}

ScalpPath ScalpPaths::straight(const Vector3d& from_mm, const Vector3d& ahead, const Vector3d& outwards,
                               double length_mm) const {
  const Vector3d v = outwards.normalized(), u = (ahead - ahead.dot(v) * v).normalized();
  const double reach_mm = length_mm + 20;
  std::vector<Vector2d> skin;
  for (const Vector2d& p : cut(mesh_, from_mm, u, v))
    if (std::abs(p.x()) < reach_mm && p.y() > -reach_mm) skin.push_back(p);
  if (skin.size() < 3) throw Error("no tape can be laid there: there is no skin");
  std::vector<Vector2d> hull = convexHull(std::move(skin));  // starts leftmost, runs along the lower side
  const auto right =
      std::max_element(hull.begin(), hull.end(), [](const auto& a, const auto& b) { return a.x() < b.x(); });
  std::vector<Vector2d> upper(right, hull.end());
  upper.push_back(hull.front());
  std::reverse(upper.begin(), upper.end());  // left to right
  std::vector<Vector3d> points;
  double laid_mm = 0;
  Vector2d last = Vector2d::Zero();
  for (std::size_t i = 1; i < upper.size() && laid_mm < length_mm; ++i) {
    const Vector2d &a = upper[i - 1], &b = upper[i];
    if (b.x() <= 0) continue;
    if (points.empty()) {
      last = a.x() >= 0 ? a : Vector2d(a + (b - a) * (-a.x() / (b.x() - a.x())));
      points.push_back(from_mm + last.x() * u + last.y() * v);
    }
    const double piece_mm = (b - last).norm(), rest_mm = length_mm - laid_mm;
    if (piece_mm > 0) {
      last += (b - last) * std::min(1.0, rest_mm / piece_mm);
      points.push_back(from_mm + last.x() * u + last.y() * v);
    }
    laid_mm += piece_mm;
  }
  if (points.size() < 2 || laid_mm < length_mm)
    throw Error(formatted("no tape of %.0f mm can be laid there: the skin ends", length_mm), {},
                "choose a smaller distance");
  return ScalpPath(std::move(points));
}

}  // namespace facenav::surface
