#include "scalp_edge.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "facenav/core/robust_statistics.h"
#include "mesh/mesh_polydata.h"

namespace facenav::surface {
namespace {

constexpr double kStep_mm = 0.25;
constexpr double kSignificant =
    0.3;  // share of the steepest slope in reach; an outer edge with less is not the skin

/// Profiles of all vertices, `length` samples each, from inside to outside.
struct Profiles {
  int length = 0;
  std::vector<float> values;
  const float* of(std::size_t vertex) const { return &values[vertex * length]; }
  float* of(std::size_t vertex) { return &values[vertex * length]; }
};

/// Trilinear sampling; outside the grid the value of its nearest end.
class Sampler {
 public:
  explicit Sampler(const volume::Volume& volume)
      : volume_(volume), voxel_from_mri_(volume.grid.mri_from_voxel.inverse()) {
    for (int a = 0; a < 3; ++a) last_[a] = volume.grid.size[a] - 1;
  }
  Eigen::Vector3d clamped(const Eigen::Vector3d& p_mri_mm) const {
    return (voxel_from_mri_ * p_mri_mm).cwiseMax(0.0).cwiseMin(last_);
  }
  float operator()(const Eigen::Vector3d& p_mri_mm) const {
    const Eigen::Vector3d ijk = clamped(p_mri_mm);
    int low[3];
    float f[3];
    for (int a = 0; a < 3; ++a) {
      low[a] = std::max(0, std::min(int(ijk[a]), volume_.grid.size[a] - 2));
      f[a] = float(ijk[a] - low[a]);
    }
    const float* v = &volume_.voxels[volume_.grid.index(low[0], low[1], low[2])];
    const std::size_t x = volume_.grid.size[0] > 1, y = volume_.grid.size[1] > 1 ? volume_.grid.size[0] : 0;
    const std::size_t z =
        volume_.grid.size[2] > 1 ? std::size_t(volume_.grid.size[0]) * volume_.grid.size[1] : 0;
    const auto mix = [](float a, float b, float t) { return a + t * (b - a); };
    const auto row = [&](std::size_t o) { return mix(v[o], v[o + x], f[0]); };
    return mix(mix(row(0), row(y), f[1]), mix(row(z), row(z + y), f[1]), f[2]);
  }

 private:
  const volume::Volume& volume_;
  Eigen::Affine3d voxel_from_mri_;
  Eigen::Vector3d last_;
};

Profiles sampleProfiles(const TriangleMesh& mesh, const Sampler& sample, double from_mm, int length) {
  Profiles out{length, std::vector<float>(mesh.vertices_mm.size() * length)};
  for (std::size_t v = 0; v < mesh.vertices_mm.size(); ++v)
    for (int s = 0; s < length; ++s)
      out.of(v)[s] = sample(mesh.vertices_mm[v] + (from_mm + s * kStep_mm) * mesh.normals[v]);
  return out;
}

/// True if the air was set to one value: the edges' outer tails are then cut off and carry no information.
bool isMaskedOutside(const Profiles& profiles) {
  std::size_t same = 0;
  const std::size_t count = profiles.values.size() / profiles.length;
  for (std::size_t v = 0; v < count; ++v) {
    const float* end = profiles.of(v) + profiles.length;
    same += end[-1] == end[-2] && end[-2] == end[-3];
  }
  return 2 * same > count;
}

void averageOverRings(Profiles& profiles, const MeshNeighbours& neighbours, int rings) {
  Profiles next = profiles;
  for (int ring = 0; ring < rings; ++ring) {
    for (std::size_t v = 0; v + 1 < neighbours.first.size(); ++v) {
      float* to = next.of(v);
      std::copy_n(profiles.of(v), profiles.length, to);
      for (int e = neighbours.first[v]; e < neighbours.first[v + 1]; ++e) {
        const float* from = profiles.of(neighbours.all[e]);
        for (int s = 0; s < profiles.length; ++s) to[s] += from[s];
      }
      const float scale = 1.f / float(1 + neighbours.first[v + 1] - neighbours.first[v]);
      for (int s = 0; s < profiles.length; ++s) to[s] *= scale;
    }
    std::swap(profiles.values, next.values);
  }
}

/// Weights w such that sum w[k] p[s + k - radius] is minus the slope of p, per mm, smoothed by a Gaussian.
std::vector<float> slopeKernel(double sigma_mm) {
  const int radius = int(std::ceil(3 * sigma_mm / kStep_mm));
  std::vector<float> kernel(2 * radius + 1);
  double moment = 0;
  for (int k = -radius; k <= radius; ++k) {
    const double x = k * kStep_mm, w = -x * std::exp(-0.5 * x * x / (sigma_mm * sigma_mm));
    kernel[k + radius] = float(w);
    moment -= w * x;
  }
  for (float& w : kernel) w = float(w / moment);
  return kernel;
}

struct Edge {
  double offset_mm = 0.0, slope = 0.0;  // slope 0: none found
  double foot_mm = 0.0;                 // where the fall-off begins, seen from outside
  double gap_mm = kNoPeak_mm;           // from the foot inwards to the maximum
  double tail_mm = kNoPeak_mm;  // standard deviation of the blurred edge, from the fall-off outside the foot
  static constexpr double kNoPeak_mm = 1e3;
};

/// Sub-sample position of the outermost local maximum of at least `least`, in samples.
std::optional<double> outermostMaximum(const std::vector<float>& f, float least) {
  for (int s = int(f.size()) - 2; s > 0; --s) {
    if (f[s] < f[s - 1] || f[s] <= f[s + 1] || f[s] < least || f[s] <= 0) continue;
    const double curvature = f[s - 1] - 2.0 * f[s] + f[s + 1];
    return s + (curvature < 0 ? std::clamp(0.5 * (f[s - 1] - f[s + 1]) / curvature, -0.5, 0.5) : 0.0);
  }
  return std::nullopt;
}

/// Standard deviation of the Gaussian that the fall-off follows outside its foot: minus the second derivative
/// of its logarithm is 1 / sigma^2. Deeper structures have no effect there.
double tailSigma_mm(const std::vector<float>& fall, int foot) {
  constexpr int kReach = 2;  // samples
  if (foot < 0 || foot + 2 * kReach >= int(fall.size()) || fall[foot + 2 * kReach] < 0.05f * fall[foot] ||
      fall[foot] <= 0)
    return Edge::kNoPeak_mm;
  const double bend =
      std::log(fall[foot]) - 2 * std::log(fall[foot + kReach]) + std::log(fall[foot + 2 * kReach]);
  return bend < 0 ? kReach * kStep_mm / std::sqrt(-bend) : Edge::kNoPeak_mm;
}

/// The foot: the outermost place where the fall-off grows fastest; and the outermost maximum of the fall-off
/// inside it.
Edge outermostEdge(const std::vector<float>& fall, double first_mm) {
  std::vector<float> growth(fall.size(), 0.f);
  for (std::size_t s = 1; s + 1 < fall.size(); ++s) growth[s] = fall[s - 1] - fall[s + 1];
  Edge edge;
  const std::optional<double> foot =
      outermostMaximum(growth, kSignificant * *std::max_element(growth.begin(), growth.end()));
  if (!foot) return edge;
  edge.foot_mm = first_mm + *foot * kStep_mm;
  edge.slope = fall[int(*foot)];
  edge.tail_mm = tailSigma_mm(fall, int(std::lround(*foot)));
  const auto peak = outermostMaximum(fall, kSignificant * *std::max_element(fall.begin(), fall.end()));
  if (peak && *peak < *foot) edge.gap_mm = (*foot - *peak) * kStep_mm, edge.slope = fall[int(*peak)];
  return edge;
}

double quantileOf(std::vector<double> values, double fraction) {
  values.erase(std::remove(values.begin(), values.end(), Edge::kNoPeak_mm), values.end());
  if (values.empty()) return Edge::kNoPeak_mm;
  return selectRank(values, std::size_t(fraction * double(values.size() - 1)));
}

/// A blurred step has its maximum one sigma of the blur inside its foot. When a dark dermis and the brighter
/// fat below are not resolved, the maximum lies deeper, in the fat: then the edge is placed one sigma inside
/// the foot. The scan's sigma is measured at the sharp edges of this head, or at the fall-off outside the
/// edges (when the dermis is thin everywhere).
void leanOnFoot(std::vector<Edge>& edges, bool has_tails) {
  constexpr double kAsSharp_mm = 0.25, kLessSure = 0.7;
  std::vector<double> gaps, tails;
  for (const Edge& edge : edges) gaps.push_back(edge.gap_mm), tails.push_back(edge.tail_mm);
  constexpr double kUnresolved = 1.2;
  const double gap_mm = quantileOf(gaps, 0.2), tail_mm = quantileOf(tails, 0.3);
  const double sigma_mm = !has_tails || gap_mm < kUnresolved * tail_mm ? gap_mm : tail_mm;
  for (Edge& edge : edges) {
    if (edge.slope <= 0) continue;
    const bool is_resolved = edge.gap_mm < sigma_mm + kAsSharp_mm;
    edge.offset_mm = edge.foot_mm - (is_resolved ? edge.gap_mm : sigma_mm);
    if (!is_resolved) edge.slope *= kLessSure;
  }
}

std::vector<Edge> findEdges(const TriangleMesh& mesh, const MeshNeighbours& neighbours, const Sampler& sample,
                            const EdgeSearch& search) {
  const std::vector<float> kernel = slopeKernel(search.slope_sigma_mm);
  const int radius = int(kernel.size()) / 2;
  const int window = int(std::lround((search.inwards_mm + search.outwards_mm) / kStep_mm)) + 1;
  Profiles profiles =
      sampleProfiles(mesh, sample, -search.inwards_mm - radius * kStep_mm, window + 2 * radius);
  const bool has_tails = !search.is_air_erased && !isMaskedOutside(profiles);
  averageOverRings(profiles, neighbours, search.rings);
  std::vector<Edge> edges(mesh.vertices_mm.size());
  std::vector<float> fall(window);
  for (std::size_t v = 0; v < edges.size(); ++v) {
    for (int s = 0; s < window; ++s) {
      fall[s] = 0;
      for (std::size_t k = 0; k < kernel.size(); ++k) fall[s] += kernel[k] * profiles.of(v)[s + k];
    }
    edges[v] = outermostEdge(fall, -search.inwards_mm);
  }
  leanOnFoot(edges, has_tails);
  return edges;
}

/// Minimises sum weight (d - measured)^2 + stiffness |grad d|^2 by Gauss-Seidel sweeps.
void relax(std::vector<double>& offset, const std::vector<Edge>& edges, const std::vector<double>& weight,
           const MeshNeighbours& neighbours, double stiffness) {
  for (int sweep = 0; sweep < 12; ++sweep)
    for (std::size_t v = 0; v < offset.size(); ++v) {
      const int begin = neighbours.first[v], end = neighbours.first[v + 1];
      double sum = 0;
      for (int e = begin; e < end; ++e) sum += offset[neighbours.all[e]];
      const double pull = end > begin ? stiffness : 0.0, total = weight[v] + pull;
      if (total > 0)
        offset[v] =
            (weight[v] * edges[v].offset_mm + (end > begin ? pull * sum / (end - begin) : 0.0)) / total;
    }
}

}  // namespace

void moveOntoEdge(TriangleMesh& mesh, const MeshNeighbours& neighbours, const volume::Volume& volume,
                  const EdgeSearch& search) {
  const Sampler sample(volume);
  const std::vector<Edge> edges = findEdges(mesh, neighbours, sample, search);
  std::vector<double> slopes;
  for (const Edge& edge : edges)
    if (edge.slope > 0) slopes.push_back(edge.slope);
  const double typical = slopes.empty() ? 0.0 : quantileOf(slopes, 0.5);
  std::vector<double> weight(edges.size()), offset(edges.size());
  for (std::size_t v = 0; v < edges.size(); ++v) {
    const double clarity = typical > 0 ? std::min(1.0, edges[v].slope / typical) : 0.0;
    weight[v] = clarity * clarity;
    offset[v] = edges[v].slope > 0 ? edges[v].offset_mm : 0.0;
  }
  // Edges that jump away from their surroundings (a ghost outside, fat inside) get no weight, and the offsets
  // are relaxed again.
  constexpr double kJump_mm = 0.7;
  for (const bool is_last : {false, true}) {
    relax(offset, edges, weight, neighbours, search.stiffness);
    if (is_last) break;
    for (std::size_t v = 0; v < edges.size(); ++v) {
      const double jump = (edges[v].offset_mm - offset[v]) / kJump_mm;
      weight[v] *= 1.0 / ((1 + jump * jump) * (1 + jump * jump));
    }
  }
  for (std::size_t v = 0; v < edges.size(); ++v)
    mesh.vertices_mm[v] =
        volume.grid.mri_from_voxel * sample.clamped(mesh.vertices_mm[v] + offset[v] * mesh.normals[v]);
  mesh.normals = vertexNormals(mesh);
}

}  // namespace facenav::surface
