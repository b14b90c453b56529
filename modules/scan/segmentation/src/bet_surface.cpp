#include "bet_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "facenav/core/robust_statistics.h"
#include "facenav/volume/mask_morphology.h"

namespace facenav::segmentation {
namespace {

using Eigen::Vector3d;
using volume::Mask;
using volume::Volume;

BetSurface icosphere(int subdivisions) {
  const double p = (1 + std::sqrt(5.0)) / 2;
  BetSurface s;
  s.vertices_mm = {{-1, p, 0},  {1, p, 0},  {-1, -p, 0}, {1, -p, 0}, {0, -1, p},  {0, 1, p},
                   {0, -1, -p}, {0, 1, -p}, {p, 0, -1},  {p, 0, 1},  {-p, 0, -1}, {-p, 0, 1}};
  s.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                 {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                 {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (auto& v : s.vertices_mm) v.normalize();
  for (int level = 0; level < subdivisions; ++level) {
    std::map<std::pair<int, int>, int> middle_of;
    const auto middle = [&](int a, int b) {
      const auto key = std::minmax(a, b);
      const auto found = middle_of.find(key);
      if (found != middle_of.end()) return found->second;
      s.vertices_mm.push_back((s.vertices_mm[a] + s.vertices_mm[b]).normalized());
      return middle_of[key] = int(s.vertices_mm.size()) - 1;
    };
    std::vector<Eigen::Vector3i> finer;
    for (const auto& t : s.triangles) {
      const int ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
      for (const Eigen::Vector3i& f : {Eigen::Vector3i(t[0], ab, ca), Eigen::Vector3i(t[1], bc, ab),
                                       Eigen::Vector3i(t[2], ca, bc), Eigen::Vector3i(ab, bc, ca)})
        finer.push_back(f);
    }
    s.triangles = std::move(finer);
  }
  return s;
}

/// Neighbours of each vertex in rows of 6 (one is repeated for the twelve vertices with 5).
std::vector<std::array<int, 6>> neighbourTable(const BetSurface& s) {
  std::vector<std::vector<int>> found(s.vertices_mm.size());
  for (const auto& t : s.triangles)
    for (int c = 0; c < 3; ++c) found[t[c]].push_back(t[(c + 1) % 3]);
  std::vector<std::array<int, 6>> table(found.size());
  for (std::size_t v = 0; v < found.size(); ++v)
    for (int n = 0; n < 6; ++n) table[v][n] = n < int(found[v].size()) ? found[v][n] : -1;
  return table;
}

std::vector<Vector3d> normalsOf(const BetSurface& s) {
  std::vector<Vector3d> normals(s.vertices_mm.size(), Vector3d::Zero());
  for (const auto& t : s.triangles) {
    const Vector3d& a = s.vertices_mm[t[0]];
    const Vector3d n = (s.vertices_mm[t[1]] - a).cross(s.vertices_mm[t[2]] - a);
    for (int c = 0; c < 3; ++c) normals[t[c]] += n;
  }
  for (auto& n : normals) n.normalize();
  return normals;
}

/// Nearest-voxel look-up along a ray, for an image of cubic voxels along the axes of Mri.
struct Sampler {
  explicit Sampler(const Volume& v)
      : image(v),
        origin(v.grid.mri_from_voxel.translation()),
        per_mm(float(1.0 / v.grid.spacing_mm().mean())),
        stride{1, v.grid.size[0], v.grid.size[0] * v.grid.size[1]} {}
  /// Voxel coordinates plus a half, so that truncation rounds.
  Eigen::Array3f toVoxel(const Vector3d& p_mm) const {
    return (p_mm - origin).cast<float>().array() * per_mm + 0.5f;
  }
  float operator()(const Eigen::Array3f& q) const {
    const auto& n = image.grid.size;
    if (!(q[0] >= 0 && q[1] >= 0 && q[2] >= 0 && q[0] < float(n[0]) && q[1] < float(n[1]) &&
          q[2] < float(n[2])))
      return outside;
    return image.voxels[std::size_t(int(q[0])) + std::size_t(int(q[1])) * stride[1] +
                        std::size_t(int(q[2])) * stride[2]];
  }
  const Volume& image;
  Vector3d origin;
  float per_mm;
  std::array<int, 3> stride;
  float outside = 0;
};

constexpr int kMinDepth_mm = 20,
              kMaxDepth_mm = 10;  // search depth of minimum and maximum (Smith 2002)
constexpr double kMinRadius_mm = 3.33, kMaxRadius_mm = 10;  // radii of curvature (Smith 2002)

/// Force along the normal, as a share of the mean edge length: Smith's equation 13.
double intensityPull(const Sampler& sample, const Vector3d& p, const Vector3d& n, const BetIntensities& t,
                     double bt) {
  float lowest = t.median, highest = t.t;
  Eigen::Array3f at = sample.toVoxel(p);
  const Eigen::Array3f step = n.cast<float>().array() * sample.per_mm;  // 1 mm inwards
  for (int d = 0; d <= kMinDepth_mm; ++d, at -= step) {
    const float value = sample(at);
    lowest = std::min(lowest, value);
    if (d < kMaxDepth_mm) highest = std::max(highest, value);
  }
  lowest = std::max(lowest, t.t2);
  highest = std::min(highest, t.median);
  if (highest <= t.t2) return 0;
  const double threshold = (highest - t.t2) * bt + t.t2;
  return 2.0 * (lowest - threshold) / (highest - t.t2);
}

double smoothness(double radius_of_curvature_mm, double factor) {
  const double e = (1 / kMinRadius_mm + 1 / kMaxRadius_mm) / 2,
               f = 6 / (1 / kMinRadius_mm - 1 / kMaxRadius_mm);
  return std::min(1.0, factor * 0.5 * (1 + std::tanh(f * (1 / radius_of_curvature_mm - e))));
}

double meanEdge(const BetSurface& s) {
  double sum = 0;
  for (const auto& t : s.triangles) sum += (s.vertices_mm[t[0]] - s.vertices_mm[t[1]]).norm();
  return sum / double(s.triangles.size());
}

}  // namespace

BetIntensities betIntensities(const Volume& image, const BetSphere& sphere, float t2, float t98) {
  BetIntensities out{t2, t2 + 0.1f * (t98 - t2), t98, 0};
  std::vector<float> inside;
  const auto& n = image.grid.size;
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) {
        const float v = image.at(i, j, k);
        if (v <= out.t || v >= t98) continue;
        if ((image.grid.toMri({double(i), double(j), double(k)}).mm - sphere.centre_mm).norm() <
            sphere.radius_mm)
          inside.push_back(v);
      }
  if (inside.empty()) return out;
  out.median = upperMedian(std::move(inside));
  return out;
}

BetSurface evolveBet(const Volume& image, const BetSphere& start, const BetIntensities& intensities,
                     const BetOptions& options, TaskMonitor& monitor) {
  BetSurface s = icosphere(options.subdivisions);
  const auto table = neighbourTable(s);
  for (auto& v : s.vertices_mm) v = start.centre_mm + 0.5 * start.radius_mm * v;
  Sampler sample(image);
  sample.outside = intensities.t2;
  std::vector<Vector3d> moved(s.vertices_mm.size());
  double edge = meanEdge(s);
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    if (iteration % 50 == 0) {
      monitor.report("growing the brain's surface", double(iteration) / options.iterations);
      edge = meanEdge(s);
    }
    const auto normals = normalsOf(s);
    for (std::size_t v = 0; v < s.vertices_mm.size(); ++v) {
      const Vector3d& p = s.vertices_mm[v];
      Vector3d mean = Vector3d::Zero();
      int count = 0;
      for (int n : table[v])
        if (n >= 0) mean += s.vertices_mm[n], ++count;
      const Vector3d step = mean / count - p;
      const Vector3d along = step.dot(normals[v]) * normals[v];
      const double normal_length = std::max(along.norm(), 1e-9);
      const double f2 = smoothness(edge * edge / (2 * normal_length), options.smoothing_factor);
      const double f3 = intensityPull(sample, p, normals[v], intensities, options.fractional_threshold);
      moved[v] = p + 0.5 * (step - along) + f2 * along + 0.05 * f3 * edge * normals[v];
    }
    s.vertices_mm.swap(moved);
  }
  return s;
}

Mask enclosed(const BetSurface& surface, const volume::VoxelGrid& grid) {
  // Marks the surface's voxels densely. Everything that cannot be reached from outside is then inside, also
  // with folds.
  Mask wall{grid, std::vector<std::uint8_t>(grid.count())};
  const Eigen::Affine3d to_voxel = grid.mri_from_voxel.inverse();
  for (const auto& t : surface.triangles) {
    const Vector3d a = to_voxel * surface.vertices_mm[t[0]], b = to_voxel * surface.vertices_mm[t[1]] - a,
                   c = to_voxel * surface.vertices_mm[t[2]] - a;
    const int steps = 1 + int(2.5 * std::max({b.norm(), c.norm(), (b - c).norm()}));
    for (int u = 0; u <= steps; ++u)
      for (int v = 0; v <= steps - u; ++v) {
        const Vector3d p = a + b * u / steps + c * v / steps;
        const int i = int(std::lround(p.x())), j = int(std::lround(p.y())), k = int(std::lround(p.z()));
        if (grid.contains(i, j, k)) wall.voxels[grid.index(i, j, k)] = 1;
      }
  }
  return fillHoles(wall);
}

}  // namespace facenav::segmentation
